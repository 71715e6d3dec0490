//! `report.html`: the report as one page, to read and to print, that needs no other file.
//!
//! The text is that of `report.md`; pictures are embedded as data URIs.

use crate::result::folder::ResultFolder;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};

/// Style of the page: narrow tables that do not break, headings on the same page as the text that
/// follows, A4 for printing.
const STYLE: &str = "\
body{font:15px/1.45 system-ui,sans-serif;color:#1b1f24;max-width:60rem;margin:2rem auto;padding:0 \
                     1rem}
h1{font-size:1.7rem;border-bottom:2px solid #2b5d8a;padding-bottom:.3rem}
h2{font-size:1.25rem;margin-top:2rem;border-bottom:1px solid #c8d0d8}
h1,h2,h3{break-after:avoid;page-break-after:avoid}
div.table{overflow-x:auto;margin:.8rem 0}
table{border-collapse:collapse;font-size:.9rem}
th,td{border:1px solid #c8d0d8;padding:.2rem .5rem;vertical-align:top}
th{background:#eef2f6;text-align:left}
tr,img,pre{break-inside:avoid;page-break-inside:avoid}
thead{display:table-header-group}
img{max-width:100%;height:auto;display:block;margin:.5rem auto}
pre{background:#f5f7f9;padding:.6rem;overflow-x:auto;font-size:.85rem;white-space:pre-wrap}
@page{size:A4;margin:18mm 15mm}
@media print{body{font-size:10pt;max-width:none;margin:0;padding:0}div.table{overflow:\
                     visible}table{font-size:8.5pt}}
";

/// The page of a report in Markdown; `picture` reads a file of the result folder.
pub fn report_html(markdown: &str, picture: impl Fn(&str) -> Option<Vec<u8>>) -> String {
    let embed = |url: CowStr<'_>| -> String {
        match picture(&url) {
            Some(bytes) => format!("data:{};base64,{}", media_type(&url), base64(&bytes)),
            None => url.to_string(),
        }
    };
    let mut title = String::new();
    let mut in_title = false;
    let mut events = Vec::new();
    // the text contains user input: raw HTML in it is shown as text, not executed
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        match event {
            Event::Html(text) | Event::InlineHtml(text) => {
                if in_title {
                    title.push_str(&text);
                }
                events.push(Event::Text(text));
            }
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => {
                let dest_url = embed(dest_url).into();
                events.push(Event::Start(Tag::Image { link_type, dest_url, title, id }));
            }
            Event::Start(Tag::Table(columns)) => {
                events.push(Event::Html("<div class=\"table\">".into()));
                events.push(Event::Start(Tag::Table(columns)));
            }
            Event::End(TagEnd::Table) => {
                events.push(Event::End(TagEnd::Table));
                events.push(Event::Html("</div>\n".into()));
            }
            event => {
                match &event {
                    Event::Start(Tag::Heading {
                        level: pulldown_cmark::HeadingLevel::H1, ..
                    }) => in_title = title.is_empty(),
                    Event::End(TagEnd::Heading(_)) => in_title = false,
                    Event::Text(text) | Event::Code(text) if in_title => title.push_str(text),
                    _ => {}
                }
                events.push(event);
            }
        }
    }
    let mut page =
        String::from("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.push_str("<meta name=\"viewport\" content=\"width=device-width\">\n<title>");
    // a text event is escaped when it is written
    push_html(&mut page, std::iter::once(Event::Text(title.into())));
    page.push_str(&format!("</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n"));
    push_html(&mut page, events.into_iter());
    page.push_str("</body>\n</html>\n");
    page
}

/// Writes `report.html` beside `report.md`, with the pictures that are already in the folder.
pub fn write(folder: &ResultFolder, markdown: &str) -> Result<(), crate::diag::Diagnostics> {
    let inside = |name: &str| std::path::Path::new(name).components().count() == 1;
    let read =
        |name: &str| inside(name).then(|| std::fs::read(folder.path().join(name)).ok()).flatten();
    folder.write("report.html", report_html(markdown, read).as_bytes())?;
    Ok(())
}

fn media_type(name: &str) -> &'static str {
    if name.ends_with(".svg") { "image/svg+xml" } else { "image/png" }
}

/// Base 64 of RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let word =
            group.iter().enumerate().fold(0u32, |w, (i, &b)| w | u32::from(b) << (16 - 8 * i));
        for i in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * i)) as usize & 63];
            out.push(if i <= group.len() { char::from(digit) } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of RFC 4648, section 10.
    #[test]
    fn base64_has_the_vectors_of_its_standard() {
        let cases = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (text, coded) in cases {
            assert_eq!(base64(text.as_bytes()), coded);
        }
        assert_eq!(base64(&[0xff, 0xef, 0xbe]), "/+++");
    }

    #[test]
    fn tables_and_pictures_are_in_the_page_and_nothing_of_the_user_runs() {
        let markdown = "# A & <b>\n\n| check | Ed |\n| --- | ---: |\n| **bolt** | 1 < 2 \
                        |\n\n![Side \
                        view](drawing.svg)\n\n![gone](gone.png)\n\n<script>alert(1)</script> and \
                        <img src=x onerror=y>\n\n```yaml\nproject: {title: \"<i>\"}\n```\n";
        let page = report_html(markdown, |name| (name == "drawing.svg").then(|| b"foo".to_vec()));
        for words in [
            "<title>A &amp; &lt;b&gt;</title>",
            "<div class=\"table\"><table><thead><tr><th>check</th><th style=\"text-align: \
             right\">Ed</th></tr></thead>",
            "<strong>bolt</strong>",
            "<img src=\"data:image/svg+xml;base64,Zm9v\" alt=\"Side view\" />",
            "<img src=\"gone.png\"",
            "&lt;script&gt;alert(1)&lt;/script&gt;",
            "@page{size:A4",
            "title: \"&lt;i&gt;\"",
        ] {
            assert!(page.contains(words), "{words}: {page}");
        }
        assert!(
            !page.contains("<script") && !page.contains("<img src=x") && !page.contains("http"),
            "{page}"
        );
        assert_eq!(page.matches("<div").count(), page.matches("</div>").count());
    }
}

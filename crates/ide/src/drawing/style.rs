//! The style sheet of pictures: light or dark as the reader prefers, black on white on paper, and readable without colour.

/// What makes a picture look as it does; a stand-alone file holds it, a page takes it over once.
///
/// 1 is a thick line, 0 a thin dashed one, what was not executed is dotted, what is unknown has dashes and dots.
pub const STYLE: &str = r#".diagram{font:13.3px "JetBrains Mono",ui-monospace,"Cascadia Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace}
.diagram text{fill:#131a17;white-space:pre}
.diagram .paper{fill:#fff}
.diagram .heading{font-weight:600}
.diagram .wire,.diagram .rail,.diagram .stroke{fill:none;stroke:#3f4b45;stroke-width:1.3}
.diagram .stroke{stroke-width:1.6}
.diagram .rail{stroke-width:3}
.diagram .face{fill:#f7f8f7;stroke:#3f4b45;stroke-width:1.3}
.diagram .circle{fill:#fff;stroke:#3f4b45;stroke-width:1.3}
.diagram .title{font-weight:600}
.diagram .pin{fill:#3f4b45}
.diagram .value,.diagram .stub text,.diagram .stub{fill:#1d4fc4}
.diagram .wire[data-flow="1"],.diagram [data-flow="1"]>.stroke{stroke:#0e9a57;stroke-width:3.2}
.diagram .wire[data-flow="0"]{stroke:#828d87;stroke-dasharray:5 4}
.diagram .wire[data-flow="not-run"]{stroke:#828d87;stroke-dasharray:1 5}
.diagram .wire[data-flow="unknown"]{stroke:#855400;stroke-dasharray:9 3 2 3}
.diagram [data-flow="not-run"]>text{fill:#5d6963;font-style:italic}
@media(prefers-color-scheme:dark){
.diagram text{fill:#eaf0ec}
.diagram .paper{fill:#131917}
.diagram .wire,.diagram .rail,.diagram .stroke{stroke:#bcc7c1}
.diagram .face{fill:#1a211e;stroke:#bcc7c1}
.diagram .circle{fill:#131917;stroke:#bcc7c1}
.diagram .pin{fill:#bcc7c1}
.diagram .value,.diagram .stub text,.diagram .stub{fill:#8fb3ff}
.diagram .wire[data-flow="1"],.diagram [data-flow="1"]>.stroke{stroke:#34c77b}
.diagram .wire[data-flow="0"]{stroke:#707e77}
.diagram .wire[data-flow="not-run"]{stroke:#707e77}
.diagram .wire[data-flow="unknown"]{stroke:#ffc861}
.diagram [data-flow="not-run"]>text{fill:#94a19a}
}
@media print{
.diagram text,.diagram .pin,.diagram .value,.diagram .stub text,.diagram .stub,.diagram [data-flow="not-run"]>text{fill:#000}
.diagram .paper,.diagram .face,.diagram .circle{fill:#fff}
.diagram .wire,.diagram .wire[data-flow],.diagram .rail,.diagram .stroke,.diagram [data-flow]>.stroke,.diagram .face,.diagram .circle{stroke:#000}
}
"#;

//! Reports of campaigns: for the terminal, as a page, for build servers.
#![cfg(feature = "parquet")]

mod command;

use command::Folder;

const PROGRAM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n L MW 12;\n +I;\n T MW 10;\n L MW 10;\n L MW 14;\n >I;\n = Q 4.0;\nEND_ORGANIZATION_BLOCK\n";
const SPEC: &str = "[campaign]\nname = \"a <b> & \\\"c\\\"\"\nfor = \"300ms\"\nsamples = 5\n[sweep]\n\"MW 12\" = { values = [1, 2, 5], unit = \"mm\" }\n\"MW 14\" = { values = [20, 40, 80, 160] }\n\
                    [draw]\n\"MW 16\" = { uniform = [0, 100] }\n[[never]]\nname = \"over <1>\"\nexpr = \"Q4.0\"\n[[sometimes]]\nname = \"it counts\"\nexpr = \"MW10 <> W#16#0\"\n\
                    [[measure]]\nname = \"sum\"\nof = \"last\"\nexpr = \"WORD_TO_INT(MW10)\"\nunit = \"m\"\n";

fn folder() -> Folder {
    let folder = Folder::with(&[("main.awl", PROGRAM), ("c.toml", SPEC)]);
    folder.run(&["campaign", "run", "c.toml", "--quiet", "--out", "r.parquet"]).code(1);
    folder
}

#[test]
fn the_terminal_gets_what_each_property_and_measure_came_to() {
    let folder = folder();
    let text = folder.run(&["campaign", "report", "r.parquet"]).code(1).stdout;
    for part in [
        "a <b> & \"c\": 60 of 60 scenarios",
        "never       over <1>   broken in ",
        "sometimes   it counts  came in 60 scenarios, first in 0",
        "last        sum",
        " m (scenario ",
        "`over <1>`",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let json = folder.run(&["campaign", "report", "r.parquet", "--json"]).code(1).json();
    assert_eq!((&json["run"], &json["scenarios"], &json["properties"][1]["came"]), (&60.into(), &60.into(), &60.into()));
    // A result of a part does not hold, whatever it came to.
    let part = folder.run(&["campaign", "run", "c.toml", "--quiet", "--only", "15..16", "--out", "p.parquet"]);
    assert_eq!(part.code, Some(0), "{}", part.stdout);
    folder.run(&["campaign", "report", "p.parquet"]).code(1).stdout("missing: scenarios 0..14, 17..59");
    folder.run(&["campaign", "report", "main.awl"]).code(2).stderr("[P7178]");
}

#[test]
fn a_page_has_verdicts_failures_and_charts_and_needs_no_network() {
    let folder = folder();
    folder.run(&["campaign", "report", "r.parquet", "--html", "r.html"]).code(1);
    let page = String::from_utf8(folder.read("r.html")).expect("text");
    for part in [
        "<h1>a &lt;b&gt; &amp; &quot;c&quot;",
        "over &lt;1&gt;",
        "where it did not pass",
        "sum over MW 14",
        "sum: how often",
        "MW 12 in mm",
        "was changed last by",
        "samples = 5",
        "<code>failures/over-1-",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(
        !page.contains("http:") && !page.contains("https:") && !page.contains("<script") && !page.contains("NaN"),
        "it needs no network and no script"
    );
    assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
}

#[test]
fn a_build_server_gets_a_case_for_each_property() {
    let folder = folder();
    folder.run(&["campaign", "report", "r.parquet", "--junit", "r.xml"]).code(1);
    let xml = String::from_utf8(folder.read("r.xml")).expect("text");
    assert!(xml.contains("tests=\"6\" failures=\"1\""), "{xml}");
    assert!(xml.contains("<testcase name=\"never: over &lt;1&gt;\"") && xml.contains("<failure message=\"broken in "), "{xml}");
    assert!(xml.contains("<testcase name=\"sometimes: it counts\" classname=\"a &lt;b&gt; &amp; &quot;c&quot;\"/>"), "{xml}");
}

//! What a farm says when the server, the user or a version is the wrong one.

mod server;

use std::process::Command;
use std::time::{Duration, Instant};

use server::{Nats, Trial, is_there};

fn pause(milliseconds: u64) {
    std::thread::sleep(Duration::from_millis(milliseconds));
}

#[test]
fn a_server_that_is_not_there_is_named_without_its_password() {
    if !is_there() {
        return;
    }
    let said = Trial::start("run", "url=nats://anna:geheim@127.0.0.1:1 id=a1 arrival=300").ends();
    assert!(said.starts_with("P7165 the NATS server at 127.0.0.1:1 cannot be reached") && !said.contains("geheim"), "{said}");
    let said = Trial::start("ready", "url=nats://anna:geheim@127.0.0.1:1").ends();
    assert!(said.starts_with("P7165") && !said.contains("geheim"), "{said}");
    let said = Trial::start("work", "url=geheim://@ patience=300").ends();
    assert!(said.starts_with("P7165 the address of the NATS server is not understood"), "{said}");
}

#[test]
fn a_server_without_jetstream_is_said_to_be_one() {
    if !is_there() {
        return;
    }
    let nats = Nats::with("", false);
    for verb in ["run", "work", "ready"] {
        let said = nats.trial(verb, "id=a1").ends();
        assert!(said.starts_with("P7167 the NATS server at") && said.contains("has no JetStream"), "{verb}: {said}");
    }
}

#[test]
fn a_server_that_is_gone_for_ever_ends_a_run_and_a_worker() {
    if !is_there() {
        return;
    }
    let mut nats = Nats::start();
    let run = nats.trial("run", "id=b2 count=100000 range=10 us=500 patience=1500");
    let worker = nats.trial("work", "patience=1500");
    pause(700);
    nats.kill();
    let begun = Instant::now();
    for said in [run.ends(), worker.ends()] {
        assert!(said.contains("P7165 the NATS server at") && said.contains("has been away for"), "{said}");
    }
    assert!(begun.elapsed() < Duration::from_secs(10), "{:?}", begun.elapsed());
}

#[test]
fn a_worker_of_another_version_refuses_a_campaign_and_says_which_it_has() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let run = nats.trial("run", "id=c3 count=100 range=10 meaning=4");
    pause(400);
    let said = nats.trial("work", "id=c3 meaning=3").ends();
    assert!(said.contains("P7168 the campaign needs meaning version 4, this worker has 3"), "{said}");
    let said = nats.trial("work", "meaning=3 idle=800").ends();
    assert!(said.contains("campaign c3: refused, the campaign needs meaning version 4"), "{said}");
    let worker = nats.trial("work", "meaning=4");
    assert!(run.ends().contains("sum=right"));
    drop(worker);
    let said = nats.trial("work", "id=C3").ends();
    assert!(said.contains("P7168 `C3` names no campaign"), "{said}");
}

#[test]
fn a_wrong_password_is_refused_and_a_right_one_is_taken() {
    if !is_there() {
        return;
    }
    let nats = Nats::with("authorization { user: anna, password: \"ge:heim\" }", true);
    let url = |login: &str| format!("url=nats://{login}127.0.0.1:{} id=d4 count=50", nats.port);
    for login in ["", "anna:falsch@", "anna@"] {
        let said = Trial::start("run", &url(login)).ends();
        assert!(said.starts_with("P7166 the NATS server at") && said.contains("refuses the user"), "{said}");
        assert!(!said.contains("falsch"), "{said}");
    }
    let worker = Trial::start("work", &url("anna:ge%3Aheim@"));
    let said = Trial::start("run", &url("anna:ge%3Aheim@")).ends();
    assert!(said.contains("sum=right"), "{said}");
    drop(worker);
}

#[test]
fn a_token_and_a_file_with_a_seed_let_in() {
    if !is_there() {
        return;
    }
    let nats = Nats::with("authorization { token: \"geheim\" }", true);
    let said = Trial::start("ready", &format!("url=nats://geheim@127.0.0.1:{}", nats.port)).ends();
    assert_eq!(said, "ready\n");
    let missing = nats.folder.join("no such file");
    let said = Trial::start("ready", &format!("url={} creds={}", nats.url(), missing.display().to_string().replace(' ', "-"))).ends();
    assert!(said.starts_with("P7166") && said.contains("cannot be read"), "{said}");
    let text = nats.folder.join("text");
    std::fs::write(&text, "geheim").expect("a file");
    let said = Trial::start("ready", &format!("url={} creds={}", nats.url(), text.display())).ends();
    assert!(said.contains("is no file with credentials") && !said.contains("geheim"), "{said}");
}

/// Two users who lack rights, beside those that the file for servers has.
const LACKING: &str = r#"
    { user: guest, password: guest, permissions: { publish: ["$JS.API.INFO"], subscribe: ["_INBOX.>"] } }
    { user: half, password: half, permissions: { publish: { deny: ["sieben.*.job"] } } }
"#;

/// The users of the file for servers, and those who lack rights.
fn users() -> String {
    let file = include_str!("../../../deploy/users.conf");
    let file = file.replace("$RUN_PASSWORD", "run").replace("$WORKER_PASSWORD", "worker");
    file.replacen("users: [", &format!("users: [{LACKING}"), 1)
}

#[test]
fn a_missing_right_is_named_and_those_of_the_file_for_servers_are_enough() {
    if !is_there() {
        return;
    }
    let nats = Nats::with(&users(), true);
    let url = |user: &str| format!("url=nats://{user}:{user}@127.0.0.1:{} id=e5 count=100 pad=700000 us=1000", nats.port);
    let said = Trial::start("run", &url("half")).ends();
    assert!(said.starts_with("P7166") && said.contains("sieben.e5.job"), "{said}");
    for verb in ["run", "work"] {
        let said = Trial::start(verb, &url("guest")).ends();
        assert!(said.contains("P7166 the NATS server refuses this user to "), "{said}");
    }
    let worker = Trial::start("work", &url("worker"));
    let said = Trial::start("run", &url("run")).ends();
    assert!(said.contains("whole=true sum=right"), "{said}");
    drop(worker);
}

/// Makes an authority, and a certificate for this computer that it signed.
fn certificates(folder: &std::path::Path) -> bool {
    let script = "set -e
        openssl req -x509 -newkey rsa:2048 -nodes -keyout ca.key -out ca.pem -days 2 -subj /CN=authority -addext basicConstraints=critical,CA:TRUE
        openssl req -newkey rsa:2048 -nodes -keyout server.key -out server.csr -subj /CN=localhost
        printf 'subjectAltName=DNS:localhost,IP:127.0.0.1' > server.ext
        openssl x509 -req -in server.csr -CA ca.pem -CAkey ca.key -CAcreateserial -out server.pem -days 2 -extfile server.ext";
    Command::new("sh").args(["-c", script]).current_dir(folder).output().is_ok_and(|output| output.status.success())
}

#[test]
fn a_server_with_a_certificate_of_a_known_authority_is_trusted() {
    if !is_there() {
        return;
    }
    let folder = std::env::temp_dir().join(format!("sieben-farm-tls-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    if !certificates(&folder) {
        return;
    }
    let path = folder.display();
    let nats = Nats::with(&format!("tls {{ cert_file: \"{path}/server.pem\", key_file: \"{path}/server.key\" }}"), true);
    let url = format!("url=tls://127.0.0.1:{}", nats.port);
    let said = Trial::start("ready", &url).ends();
    assert!(said.starts_with("P7165 no secure connection"), "{said}");
    let said = Trial::start("ready", &format!("{url} ca={path}/no-such.pem")).ends();
    assert!(said.starts_with("P7166") && said.contains("no-such.pem"), "{said}");
    let with_authority = format!("{url} ca={path}/ca.pem id=f6 count=50");
    let worker = Trial::start("work", &with_authority);
    let said = Trial::start("run", &with_authority).ends();
    assert!(said.contains("sum=right"), "{said}");
    drop(worker);
    std::fs::remove_dir_all(&folder).expect("the folder goes");
}

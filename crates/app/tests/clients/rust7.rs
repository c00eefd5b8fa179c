//! What rust7 can do, against a running CPU: `client PORT all`. It has no multi-item jobs, no clock, no blocks and no control.
//!
//! Built by `cargo xtask clients` in a crate of its own below `target/clients/`.

use rust7::client::{S7_AREA_DB, S7_AREA_MK, S7_AREA_PA, S7_AREA_PE, S7_WL_BIT, S7_WL_BYTE, S7Client, S7Error};

/// Prints a check as one line of JSON. What was got is made of digits and words: nothing in it needs to be escaped but quotes.
fn check(name: &str, got: Result<String, S7Error>, wanted: &str) {
    let got = got.unwrap_or_else(|error| format!("{error:?}"));
    println!("{{\"check\": \"{name}\", \"ok\": {}, \"got\": \"{}\"}}", got == wanted, got.replace('\\', "\\\\").replace('"', "\\\""));
}

fn read(client: &mut S7Client, area: u8, db: u16, start: u16, bytes: usize) -> Result<String, S7Error> {
    let mut data = vec![0; bytes];
    client.read_area(area, db, start, S7_WL_BYTE, &mut data)?;
    Ok(data.iter().map(|byte| format!("{byte:02x}")).collect())
}

fn write(client: &mut S7Client, area: u8, db: u16, start: u16, data: &[u8]) -> Result<String, S7Error> {
    client.write_area(area, db, start, S7_WL_BYTE, data)?;
    read(client, area, db, start, data.len())
}

fn main() {
    let port = std::env::args().nth(1).and_then(|port| port.parse().ok()).expect("the first argument is the port");
    let mut client = S7Client::new();
    client.set_timeout(10_000, 10_000, 10_000).expect("limits of time can be set");
    client.set_connection_port(port).expect("a port can be set");
    check("connect", client.connect_s7300("127.0.0.1").map(|()| client.pdu_length.to_string()), "240");

    check("read a REAL", read(&mut client, S7_AREA_DB, 1, 0, 4), "41480000");
    check("read all types", read(&mut client, S7_AREA_DB, 1, 0, 18), "4148000004d2000111700100abcd12345678");
    check("read a bit", client.read_bit(S7_AREA_DB, 1, 10, 0).map(|bit| bit.to_string()), "true");
    let mut bit = [0];
    check("read a bit by its number", client.read_area(S7_AREA_DB, 1, 81, S7_WL_BIT, &mut bit).map(|()| bit[0].to_string()), "0");
    check("read inputs", read(&mut client, S7_AREA_PE, 0, 0, 2), "0000");
    // Inputs are those of the next scan.
    let written = write(&mut client, S7_AREA_PE, 0, 0, &[0x12]);
    std::thread::sleep(std::time::Duration::from_millis(200));
    check("write inputs", written.and_then(|_| read(&mut client, S7_AREA_PE, 0, 0, 1)), "12");
    check("write outputs", write(&mut client, S7_AREA_PA, 0, 4, &[0xA5]), "a5");
    check("write bit memory", write(&mut client, S7_AREA_MK, 0, 10, &[1, 2, 3, 4]), "01020304");
    check("write a data block", write(&mut client, S7_AREA_DB, 1, 4, &[0x10, 0xE1]), "10e1");
    let set = client.write_bit(S7_AREA_MK, 0, 20, 3, true).and_then(|()| read(&mut client, S7_AREA_MK, 0, 20, 1));
    check("write a bit", set, "08");
    let cleared = client.write_bit(S7_AREA_MK, 0, 20, 3, false).and_then(|()| read(&mut client, S7_AREA_MK, 0, 20, 1));
    check("clear a bit", cleared, "00");

    let block: Vec<u8> = (0..600_u16).map(|number| (number % 251) as u8).collect();
    let hex: String = block.iter().map(|byte| format!("{byte:02x}")).collect();
    check("write more than a PDU", write(&mut client, S7_AREA_DB, 1, 52, &block), &hex);
    check("pieces of a large block", Ok(client.chunks.to_string()), "3");

    check("a data block that is missing", read(&mut client, S7_AREA_DB, 999, 0, 4), "S7NotFound");
    check("beyond the end of a data block", read(&mut client, S7_AREA_DB, 1, 650, 10), "S7InvalidAddress");
    check("beyond the end of bit memory", read(&mut client, S7_AREA_MK, 0, 2047, 2), "S7InvalidAddress");
    check("the connection goes on", read(&mut client, S7_AREA_DB, 1, 0, 4), "41480000");
    client.disconnect();
    println!("{{\"check\": \"end\", \"ok\": true, \"got\": \"\"}}");
}

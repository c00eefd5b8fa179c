//! What ran when a statement sent the CPU to STOP: its blocks, registers and local data, from the scan run again.

use serde_json::{Value as Json, json};
use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::machine::{Registers, registers::STATUS_BITS};
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_lang::reason::{Moment, Reasons};
use sieben_workspace::Refusal;
use sieben_workspace::past::{Seen, Viewer};
use sieben_workspace::refusal::capitalized;

use crate::hub::Hub;
use crate::live::program::{Known, Speech, word};
use crate::past::not_kept;

/// Bytes of local data of a block that are shown.
const LOCAL_BYTES_MAX: usize = 256;
/// Lines of the source before and after the statement.
const LINES_AROUND: u32 = 2;

/// A block that runs.
#[derive(Clone, Copy, Debug)]
struct Running {
    place: FaultPlace,
    db: u64,
    di: u64,
    /// Its local data in those of its priority class.
    local: (u32, u32),
}

/// Keeps what runs before each statement: what is left in the end is the one that did not end.
#[derive(Default)]
struct Watch {
    running: Vec<Running>,
    registers: Registers,
}

impl Tracer for Watch {
    fn pauses_before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let registers = &machine.registers;
        self.registers.clone_from(registers);
        let Some(frame) = machine.frames.last() else { return false };
        self.running.truncate(machine.frames.len() - 1);
        self.running.push(Running { place, db: registers.db_number, di: registers.di_number, local: (frame.local_base, frame.local_size) });
        false
    }

    fn statement(&mut self, _: &Machine, _: &StatementEvent) {}
}

/// What ran when a statement sent the CPU to STOP; `null` where it runs, or was stopped otherwise.
///
/// # Errors
/// The scan is not kept.
pub(crate) fn stacks(hub: &Hub, speech: Speech) -> Result<Json, Refusal> {
    let stopped = hub.gate.look(|plant| {
        let cause = plant.cpu.stop_cause().filter(|_| plant.cpu.mode() == OperatingMode::Stop)?;
        Some((plant.scans, cause.place?, cause.text.clone(), cause.first_event))
    })?;
    let Some((scan, place, text, event)) = stopped else { return Ok(Json::Null) };
    let program = hub.program();
    let mut watch = Watch::default();
    let mut viewer = Viewer::default();
    let Seen { cpu, .. } = viewer.traced(hub.desk.past(), scan, &mut watch).map_err(not_kept)?;
    let why = why(&program, cpu, (place, event), (&watch.registers, speech));
    let placed = program.facts.places().of(place);
    let (file, line) = placed.line.clone().unzip();
    let block = |running: &Running| {
        let line = program.facts.places().of(running.place).line.map(|(_, line)| line);
        json!({
            "block": word(running.place.block), "symbol": symbol(&program, running.place), "network": program.network(running.place), "line": line,
            "db": running.db, "di": running.di,
        })
    };
    Ok(json!({
        "n": scan, "text": format!("{}.", capitalized(text.trim_end_matches('.'))), "reason": why,
        "place": { "block": word(place.block), "network": program.network(place), "line": line, "file": file },
        "register": register(&program, (place, event), &watch.registers),
        "source": source(&program, place, line), "b": watch.running.iter().rev().map(block).collect::<Json>(),
        "i": interrupted(&watch.registers, cpu), "l": watch.running.iter().rev().map(|running| local(cpu, running)).collect::<Json>(),
    }))
}

fn symbol(program: &Known, place: FaultPlace) -> String {
    program.facts.block_names.get(&place.block).cloned().unwrap_or_default()
}

/// What the statement was about to do, and why it could not.
fn why(program: &Known, cpu: &Cpu, (place, event): (FaultPlace, u16), (registers, speech): (&Registers, Speech)) -> Option<String> {
    let build = program.facts.build.as_ref()?;
    let reasons = Reasons::new(&build.compiled, &build.project.texts.program, &build.project.symbols);
    let reasons = speech.mnemonics.map_or(reasons, |mnemonics| reasons.spelled(program.spelled(mnemonics)));
    let done = StatementEvent { place, before: registers.clone(), after: registers.clone() };
    let moment = Moment { event: &done, before: None, after: cpu.machine(), fault: Some(event) };
    Some(format!("{}.", capitalized(&reasons.sentence(&moment, speech.language)))).filter(|text| text.len() > 1)
}

/// The register that was wrong: the one through which an address came, or the number that cannot be converted.
fn register(program: &Known, (place, event): (FaultPlace, u16), registers: &Registers) -> Option<Json> {
    let span = *program.facts.program.code.get(&place.block)?.spans.get(place.statement as usize)?;
    let (_, file) = program.facts.sources.iter().find(|&(id, _)| id == span.file)?;
    let text = file.text.get(span.start as usize..span.end as usize)?.to_ascii_uppercase();
    let is_address = matches!(event, 0x2522..=0x2525 | 0x2528 | 0x2529 | 0x2942 | 0x2943);
    let (name, value) = match event {
        0x2521 => ("ACCU 1", registers.accu1),
        _ if is_address && text.contains("AR1") => ("AR1", registers.ar1),
        _ if is_address && text.contains("AR2") => ("AR2", registers.ar2),
        _ => return None,
    };
    Some(json!({ "name": name, "value": format!("16#{:08X}", value as u32) }))
}

fn source(program: &Known, place: FaultPlace, line: Option<u32>) -> Json {
    let span = program.facts.program.code.get(&place.block).and_then(|code| code.spans.get(place.statement as usize));
    let file = span.and_then(|span| program.facts.sources.iter().find(|&(id, _)| id == span.file));
    let (Some((_, file)), Some(line)) = (file, line) else { return json!([]) };
    let first = line.saturating_sub(LINES_AROUND).max(1);
    let shown =
        (1_u32..).zip(file.text.lines()).skip_while(|&(number, _)| number < first).take_while(|&(number, _)| number <= line + LINES_AROUND);
    shown.map(|(number, text)| json!({ "line": number, "text": text, "failed": number == line })).collect()
}

fn interrupted(registers: &Registers, cpu: &Cpu) -> Json {
    let long = |value: u64| format!("16#{:08X}", value as u32);
    let accus = [registers.accu1, registers.accu2, registers.accu3, registers.accu4];
    let mut object = json!({
        "ar1": long(registers.ar1), "ar2": long(registers.ar2), "stw": format!("16#{:04X}", registers.status().0), "db": registers.db_number,
        "di": registers.di_number,
        "bits": STATUS_BITS.iter().map(|&bit| (bit.name().to_owned(), json!(registers.get(bit)))).collect::<serde_json::Map<_, _>>(),
    });
    for (number, value) in (1..).zip(accus.iter().take(usize::from(cpu.cpu_type().accumulators))) {
        object[format!("accu{number}")] = json!(long(*value));
    }
    object
}

/// The local data of a block: they stay as they were when the CPU went to STOP.
fn local(cpu: &Cpu, running: &Running) -> Json {
    let memory = &cpu.machine().memory;
    let (base, size) = (running.local.0 as usize, running.local.1 as usize);
    let shown = size.min(LOCAL_BYTES_MAX);
    let begin = memory.layout.local.start.saturating_add(base);
    let bytes = memory.arena.get(begin..begin.saturating_add(shown)).unwrap_or_default();
    let text: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    json!({ "block": word(running.place.block), "bytes": text.join(" "), "more": size - shown })
}

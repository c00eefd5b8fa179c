//! What each system function does, in a sentence.

use sieben_model::block::{BlockId, BlockKind};

/// Number and sentence of the system functions (SFC) that the CPU has.
const FUNCTIONS: &[(u16, &str)] = &[
    (0, "Sets the clock"),
    (1, "Reads the clock"),
    (2, "Sets a run-time meter"),
    (3, "Starts or stops a run-time meter"),
    (4, "Reads a run-time meter"),
    (5, "The logical address of a channel of a module"),
    (6, "The start information of the organization block that runs, and of the last startup block"),
    (13, "The diagnostic data of a DP slave"),
    (14, "Reads consistent data of a DP slave or PROFINET device"),
    (15, "Writes consistent data to a DP slave or PROFINET device"),
    (20, "Copies an area of memory; areas must not overlap"),
    (21, "Fills an area of memory with the contents of another one, over and over"),
    (22, "Makes a data block"),
    (23, "Deletes a data block that the program has made"),
    (24, "Whether a data block exists, how long it is, and whether it is write-protected"),
    (25, "Compresses the work memory"),
    (26, "Reads the inputs into their process image"),
    (27, "Writes the process image of the outputs to the modules"),
    (28, "Sets the date, time and period of a time-of-day interrupt"),
    (29, "Cancels a time-of-day interrupt"),
    (30, "Activates a time-of-day interrupt that is set"),
    (31, "The state of a time-of-day interrupt"),
    (32, "Starts a delay interrupt, 1 ms to 60 s from now"),
    (33, "Cancels a delay interrupt that has not come yet"),
    (34, "The state of a delay interrupt"),
    (35, "Starts OB 60, on all CPUs of a multicomputing rack"),
    (36, "Masks synchronous errors: they start no OB 121 or OB 122"),
    (37, "Unmasks synchronous errors"),
    (38, "Which masked synchronous errors have come; clears them"),
    (39, "Disables interrupts: their events are lost"),
    (40, "Enables interrupts that SFC 39 disabled"),
    (41, "Delays interrupts of higher priority until SFC 42"),
    (42, "Ends a delay of interrupts"),
    (43, "Lets the watchdog begin anew"),
    (44, "The value that a failed load delivers, given by OB 121 or OB 122"),
    (46, "Brings the CPU to STOP"),
    (47, "Waits up to 32767 µs"),
    (49, "The slot of the module with a logical address"),
    (50, "All logical addresses of a module"),
    (51, "Reads a part of the system status list"),
    (52, "Makes an entry in the diagnostic buffer"),
    (58, "Writes a data record to a module"),
    (59, "Reads a data record of a module"),
    (62, "The state of a connection that a communication SFB uses"),
    (64, "The system time in milliseconds, from 0 to 2147483647 and again from 0"),
    (65, "Sends data to a partner outside the own station"),
    (66, "Receives data that a partner has sent with SFC 65"),
    (67, "Reads data of a partner outside the own station"),
    (68, "Writes data to a partner outside the own station"),
    (69, "Ends a connection to a partner outside the own station"),
    (78, "How long an organization block runs"),
    (79, "Sets a range of output bits"),
    (80, "Resets a range of output bits"),
    (81, "Copies an area of memory; no interrupt comes between"),
    (83, "Reads from a data block in the load memory"),
    (84, "Writes into a data block in the load memory"),
    (85, "Makes a data block, retentive or not"),
    (100, "Sets the clock, its zone and daylight saving time"),
    (101, "Sets, starts, stops and reads a run-time meter of 32 bits"),
];

/// Number and sentence of the system function blocks (SFB) that the CPU has.
const FUNCTION_BLOCKS: &[(u16, &str)] = &[
    (0, "IEC counter: up"),
    (1, "IEC counter: down"),
    (2, "IEC counter: up and down"),
    (3, "IEC timer: a pulse"),
    (4, "IEC timer: an on-delay"),
    (5, "IEC timer: an off-delay"),
    (8, "Sends data over a connection without acknowledgement"),
    (9, "Receives data that a partner has sent with SFB 8"),
    (12, "Sends a block of data over a connection"),
    (13, "Receives a block of data that a partner has sent with SFB 12"),
    (14, "Reads data of a partner over a connection"),
    (15, "Writes data to a partner over a connection"),
    (32, "A drum sequencer with up to 16 steps"),
    (41, "A PID controller with a continuous output"),
    (42, "A PI controller for a valve that a motor moves"),
    (43, "A manipulated value as pulses"),
    (52, "Reads a data record of a module"),
    (53, "Writes a data record to a module"),
    (54, "The event of a module that started an organization block"),
];

/// What a system block does, in a sentence without its full stop; `None` for one that the CPU does not have.
pub fn summary(block: BlockId) -> Option<&'static str> {
    let table = match block.kind {
        BlockKind::SystemFunction => FUNCTIONS,
        BlockKind::SystemFunctionBlock => FUNCTION_BLOCKS,
        _ => return None,
    };
    table.iter().find(|(number, _)| *number == block.number).map(|&(_, sentence)| sentence)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_that_the_cpu_has_and_no_other_has_a_sentence() {
        for block in crate::system::numbered() {
            assert_eq!(summary(block.block).is_some(), block.only.is_none(), "{}", block.block);
        }
        let known = crate::system::numbered().iter().filter(|block| block.only.is_none()).count();
        assert_eq!(FUNCTIONS.len() + FUNCTION_BLOCKS.len(), known);
    }
}

//! Scenarios: what happens to a CPU and what is expected of it, one line each.

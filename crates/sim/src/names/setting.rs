//! Values that go to names.

use sieben_cpu::Cpu;
use sieben_model::value::Value;

use super::{Name, NameError};

/// A value that goes to a name: read once, set as often as it is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Where it goes.
    pub name: Name,
    /// What.
    pub value: Value,
    /// The value as the user wrote it.
    pub text: String,
}

impl Setting {
    /// Reads the value for a name.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn new(name: Name, text: &str) -> Result<Self, NameError> {
        Ok(Self { value: name.value(text)?, name, text: text.to_owned() })
    }

    /// Gives the name its value.
    ///
    /// # Errors
    /// The CPU has nothing of that name that could be set.
    pub fn apply(&self, cpu: &mut Cpu) -> Result<(), NameError> {
        self.name.set(cpu, &self.value)
    }
}

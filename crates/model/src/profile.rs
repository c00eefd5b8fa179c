//! Profiles: whose rules hold where awlsim and the manual differ.

use crate::cpu_type::CpuType;

/// Whose rules hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// Those of the manual.
    #[default]
    Siemens,
    /// Those of awlsim, where a program can depend on them.
    Awlsim,
}

/// One rule of awlsim that differs from the manual.
pub struct Difference {
    /// A short name.
    pub name: &'static str,
    /// What awlsim does, in one sentence.
    pub theirs: &'static str,
    /// What the manual says, in one sentence.
    pub ours: &'static str,
    /// Makes a CPU type do it.
    apply: fn(&mut CpuType),
}

/// All differences that the profile [`Profile::Awlsim`] switches on.
pub const DIFFERENCES: &[Difference] = &[
    Difference {
        name: "block numbers",
        theirs: "An FC, FB or DB has a number up to 65535.",
        ours: "The CPU type sets the greatest number, such as FC 7999 and DB 16000.",
        apply: |cpu| (cpu.fc_number_max, cpu.db_number_max) = (u16::MAX, u16::MAX),
    },
    Difference {
        name: "status word",
        theirs: "`L STW` and `T STW` move all nine status bits on every CPU.",
        ours: "A CPU with two accumulators does not move /FC, STA and OR.",
        apply: |cpu| cpu.status_word_whole = true,
    },
    Difference {
        name: "startup",
        theirs: "A CPU with four accumulators starts with OB 102 if the program has it, else with OB 100.",
        ours: "A start is a warm restart with OB 100, unless another one is asked for.",
        apply: |cpu| cpu.starts_cold = true,
    },
    Difference {
        name: "REAL comparison",
        theirs: "Two REAL numbers compare by their difference: they are equal if it is denormal, and have no order if both are infinite with one sign.",
        ours: "Two REAL numbers compare by their values.",
        apply: |cpu| cpu.compares_real_by_difference = true,
    },
];

impl Profile {
    /// All profiles.
    pub const ALL: [Self; 2] = [Self::Siemens, Self::Awlsim];

    /// The name that `--profile` takes.
    pub fn name(self) -> &'static str {
        match self {
            Self::Siemens => "siemens",
            Self::Awlsim => "awlsim",
        }
    }

    /// The profile with this name, without regard to case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|profile| profile.name().eq_ignore_ascii_case(name))
    }

    /// A CPU type under the rules of this profile.
    pub fn applied_to(self, cpu: &CpuType) -> CpuType {
        let mut cpu = *cpu;
        if self == Self::Awlsim {
            DIFFERENCES.iter().for_each(|difference| (difference.apply)(&mut cpu));
        }
        cpu
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_difference_changes_the_smallest_cpu_and_only_its_profile_does() {
        let cpu = CpuType::default();
        assert_eq!(Profile::Siemens.applied_to(&cpu), cpu);
        for difference in DIFFERENCES {
            let mut changed = cpu;
            (difference.apply)(&mut changed);
            assert_ne!(changed, cpu, "{}", difference.name);
        }
        assert_ne!(Profile::Awlsim.applied_to(&cpu), cpu);
        assert_eq!(Profile::ALL.map(|profile| Profile::from_name(profile.name())), Profile::ALL.map(Some));
    }
}

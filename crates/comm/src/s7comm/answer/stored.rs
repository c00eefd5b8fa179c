//! Blocks that were downloaded and not linked: the CPU keeps their images, and none of them runs.

use std::collections::BTreeMap;

use crate::s7comm::job::BlockType;
use crate::s7comm::wire::codes::Refusal;

/// Most bytes that all images have together: that of the load memory that the CPU shows.
pub const STORED_BYTES_MAX: usize = 8 << 20;
/// Most images: as many numbers as the data blocks of the largest CPU type have.
pub const STORED_BLOCKS_MAX: usize = 16_000;

/// The images of passive blocks. They live as long as the run.
#[derive(Debug, Default)]
pub struct StoredBlocks {
    images: BTreeMap<(BlockType, u16), Vec<u8>>,
    bytes: usize,
}

impl StoredBlocks {
    /// The image of a block.
    pub fn image(&self, block_type: BlockType, number: u16) -> Option<&[u8]> {
        self.images.get(&(block_type, number)).map(Vec::as_slice)
    }

    /// The numbers of a type, ascending, with their images.
    pub fn of_type(&self, block_type: BlockType) -> impl Iterator<Item = (u16, &[u8])> {
        self.images.range((block_type, 0)..=(block_type, u16::MAX)).map(|(&(_, number), image)| (number, image.as_slice()))
    }

    /// Keeps an image, in place of one with the same name.
    ///
    /// # Errors
    /// There is no room for it; the old one stays.
    pub fn keep(&mut self, block_type: BlockType, number: u16, image: Vec<u8>) -> Result<(), Refusal> {
        let old = self.image(block_type, number);
        let blocks = self.images.len() + usize::from(old.is_none());
        let bytes = (self.bytes - old.map_or(0, <[u8]>::len)).saturating_add(image.len());
        if bytes > STORED_BYTES_MAX || blocks > STORED_BLOCKS_MAX {
            return Err(Refusal::NoMemory);
        }
        self.bytes = bytes;
        self.images.insert((block_type, number), image);
        Ok(())
    }

    /// Forgets an image; `false` if there was none.
    pub fn forget(&mut self, block_type: BlockType, number: u16) -> bool {
        let image = self.images.remove(&(block_type, number));
        self.bytes -= image.as_ref().map_or(0, Vec::len);
        image.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use BlockType::{DataBlock, Function};

    #[test]
    fn images_are_kept_by_type_and_number() {
        let mut stored = StoredBlocks::default();
        for (block_type, number, byte) in [(Function, 2, 1), (Function, 1, 2), (DataBlock, 1, 3), (Function, 1, 4)] {
            assert_eq!(stored.keep(block_type, number, vec![byte; 2]), Ok(()));
        }
        assert_eq!(stored.of_type(Function).collect::<Vec<_>>(), [(1, &[4, 4][..]), (2, &[1, 1])]);
        assert_eq!(stored.image(DataBlock, 1), Some(&[3, 3][..]));
        assert!(stored.forget(Function, 1) && !stored.forget(Function, 1));
        assert_eq!((stored.image(Function, 1), stored.bytes), (None, 4));
    }

    #[test]
    fn the_load_memory_has_an_end() {
        let mut stored = StoredBlocks::default();
        let half = STORED_BYTES_MAX / 2;
        assert_eq!(stored.keep(Function, 1, vec![0; half]), Ok(()));
        assert_eq!(stored.keep(Function, 2, vec![0; half]), Ok(()));
        assert_eq!(stored.keep(Function, 3, vec![0; 1]), Err(Refusal::NoMemory));
        assert_eq!(stored.keep(Function, 2, vec![0; half - 1]), Ok(()), "in place of the other one");
        assert_eq!(stored.keep(Function, 3, vec![0; 1]), Ok(()));
        assert_eq!(stored.keep(Function, 1, vec![0; half + 1]), Err(Refusal::NoMemory));
        assert_eq!(stored.image(Function, 1).map(<[u8]>::len), Some(half), "the old one stays");
    }

    #[test]
    fn there_are_only_so_many_images() {
        let mut stored = StoredBlocks::default();
        for number in 0..STORED_BLOCKS_MAX as u16 {
            assert_eq!(stored.keep(DataBlock, number, vec![0]), Ok(()));
        }
        assert_eq!(stored.keep(Function, 1, vec![0]), Err(Refusal::NoMemory));
        assert_eq!(stored.keep(DataBlock, 1, vec![1]), Ok(()));
    }
}

/** How blocks and addresses are written. */

/** `OB 1`, as people read it. */
export const named = (block: string): string => block.replace(/(\D)(\d)/, '$1 $2');

/** `I0.1` or `OB1`: without the space, as ids and addresses of the page have it. */
export const joined = (text: string): string => text.replace(' ', '');

const LETTERS: Record<string, string> = { I: 'E', Q: 'A', C: 'Z', E: 'I', A: 'Q', Z: 'C' };
const inOther = (address: string, letters: RegExp): string => address.replace(letters, (_, before: string, letter: string) => before + (LETTERS[letter] ?? letter));

/** An address as all that the server says has it: English. */
export const english = (address: string): string => inOther(address, /^(P?)([EAZ])(?=[BWD]? ?\d)/);

/** An address in German mnemonics. */
export const german = (address: string): string => inOther(address, /^(P?)([IQC])(?=[BWD]? ?\d)/);

/** How blocks and addresses are written. */

/** `OB 1`, as people read it. */
export const named = (block: string): string => block.replace(/(\D)(\d)/, '$1 $2');

/** `I0.1` or `OB1`: without the space, as ids and addresses of the page have it. */
export const joined = (text: string): string => text.replace(' ', '');

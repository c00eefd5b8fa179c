/** Names that a user of this browser has added to the watch table. */
const KEY = 'watch-added';

export const added = (): string[] => JSON.parse(localStorage.getItem(KEY) ?? '[]') as string[];

export const keepAdded = (names: string[]): void => localStorage.setItem(KEY, JSON.stringify(names));

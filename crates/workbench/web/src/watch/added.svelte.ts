/** Names that a user of this browser has added to the watch table, for each project. */
import { page } from '../state.svelte';

class Added {
  #project = $state('');
  #names = $state.raw<string[]>([]);

  get names(): string[] {
    return this.#project === page.project ? this.#names : stored();
  }

  add(name: string): void {
    if (!this.names.includes(name)) this.#keep([...this.names, name]);
  }

  remove(name: string): void {
    this.#keep(this.names.filter((one) => one !== name));
  }

  #keep(names: string[]): void {
    this.#project = page.project;
    this.#names = names;
    localStorage.setItem(key(), JSON.stringify(names));
  }
}
const key = (): string => `watch-added ${page.project}`;
const stored = (): string[] => JSON.parse(localStorage.getItem(key()) ?? '[]') as string[];

export const added = new Added();

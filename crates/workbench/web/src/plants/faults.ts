/** What a picture has when something can fail: the menu, and what is wrong in words. */
export { default as Menu } from './FaultMenu.svelte';
export { default as Wrongs } from './Wrongs.svelte';

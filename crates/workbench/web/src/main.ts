/** Where the page begins. */
import { mount } from 'svelte';
import './style/tokens.css';
import './style/base.css';
import './style/shell.css';
import './style/panels.css';
import './style/program.css';
import './style/small.css';
import App from './App.svelte';
import { route } from './route.svelte';
import { theme } from './theme.svelte';

theme.start();
route.start();
mount(App, { target: document.body });

// What is measured and not tested: `cargo xtask web --bench`, `cargo xtask soak page`.
import { defineConfig } from '@playwright/test';
import usual from '../playwright.config';

export default defineConfig({ ...usual, testDir: '.', workers: 1, fullyParallel: false, timeout: 180_000, outputDir: '../../../../target/page-bench' });

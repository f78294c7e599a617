// SPDX-License-Identifier: GPL-3.0-or-later
import { render } from 'preact';
import { reportOf } from './model';
import { inflateJson } from './packed';
import { checked, type Times } from './results';
import { App } from './ui/App';
import './style/page.css';

async function start(root: HTMLElement): Promise<void> {
  try {
    const results = checked(await inflateJson('results'));
    const times = (await inflateJson('times').catch(() => undefined)) as Times | undefined;  // a report without is one
    const report = reportOf(results, times);
    render(<App report={report} />, root);
    performance.mark('rendered');
  } catch (error) {
    document.title = 'handhold: no report';
    root.setAttribute('role', 'alert');
    root.textContent = `This page cannot show its results: ${error instanceof Error ? error.message : String(error)}.`;
  }
}

void start(document.getElementById('app')!);

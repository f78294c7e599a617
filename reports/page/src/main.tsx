import { render } from 'preact';
import { reportOf } from './model';
import { inflateJson } from './packed';
import { checked } from './results';
import { App } from './ui/App';
import './style/page.css';

async function start(root: HTMLElement): Promise<void> {
  try {
    const report = reportOf(checked(await inflateJson('results')));
    render(<App report={report} />, root);
    performance.mark('rendered');
  } catch (error) {
    document.title = 'handhold: no report';
    root.setAttribute('role', 'alert');
    root.textContent = `This page cannot show its results: ${error instanceof Error ? error.message : String(error)}.`;
  }
}

void start(document.getElementById('app')!);

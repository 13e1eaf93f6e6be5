// The certificate: what a laboratory signs, on one or two pages of its own.

import { element } from '../dom.js';
import { certificateBoundsFigure } from './bounds.js';
import { certificateDevicesFigure } from './devices.js';
import { certificateHeadFigure } from './head.js';
import { certificateRecordsFigure, certificateSignatureFigure } from './signatures.js';

export const certificateSection = {
  id: 'certificate',
  title: 'Certificate',
  controls: certificateControls,
  figures: [certificateHeadFigure, certificateDevicesFigure, certificateBoundsFigure, certificateSignatureFigure, certificateRecordsFigure],
};

// Prints this section alone.
function certificateControls() {
  const button = element('button', { type: 'button', class: 'action' }, 'Print the certificate alone');
  button.addEventListener('click', () => {
    document.documentElement.dataset.only = 'certificate';
    window.print();
  });
  window.addEventListener('afterprint', () => delete document.documentElement.dataset.only);
  return [button, element('span', { class: 'muted' }, 'The lines below can be filled in here before printing.')];
}

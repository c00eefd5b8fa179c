/** Lets the browser keep something as a file. */
export function saveFile(name: string, data: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([data], { type: 'text/plain' }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

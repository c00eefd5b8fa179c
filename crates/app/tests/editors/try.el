;; What Emacs shows of `main.awl` with the profile of the book: what is wrong, and what a word means.
(load (expand-file-name "profile.el") nil t)
(setq eglot-sync-connect 60)
(condition-case why
    (progn
      (find-file "main.awl")
      ;; As after a command of the user: what Eglot has put off is done.
      (run-hooks 'post-command-hook)
      (let ((server (or (eglot-current-server) (error "no server")))
            (end (+ (float-time) 60)))
        (while (and (null (flymake-diagnostics)) (< (float-time) end))
          (accept-process-output nil 0.1)
          (flymake-start nil nil))
        (dolist (one (flymake-diagnostics))
          (let ((text (flymake-diagnostic-text one)))
            (string-match "P[0-9]+" text)
            (princ (format "line %d: %s\n" (line-number-at-pos (flymake-diagnostic-beg one)) (match-string 0 text)))))
        (goto-char (point-min))
        (forward-line 2)
        (forward-char 3)
        (let* ((answer (jsonrpc-request server :textDocument/hover (eglot--TextDocumentPositionParams)))
               (text (plist-get (plist-get answer :contents) :value)))
          (princ (format "hover: %s\n" (car (split-string text "\n")))))))
  (error (princ (format "failed: %S\n" why))))

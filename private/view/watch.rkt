#lang racket/base
;; Files that change.
(provide file-stamps changed? watch-files)

;; How often is looked, in seconds. What is found changed twice in a row is still being written.
(define PAUSE 0.25)

;; file-stamps : a hash from each of the paths to what tells a file's state from another one, #f where
;; there is no such file.
(define (file-stamps paths)
  (for/hash ([path (in-list paths)])
    (values path
            (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
              (define stat (file-or-directory-stat path))
              (list (hash-ref stat 'modify-time-nanoseconds) (hash-ref stat 'size)
                    (hash-ref stat 'inode))))))

;; changed? : whether a path that both have has another stamp.
(define (changed? before after)
  (for/or ([(path stamp) (in-hash after)])
    (not (equal? stamp (hash-ref before path stamp)))))

;; watch-files : a thread that calls act whenever some of the files were changed and rest again.
;; files: a procedure that returns their paths, which may become others.
(define (watch-files files act)
  (thread
   (lambda ()
     (let loop ([known (file-stamps (files))] [moving? #f])
       (sleep PAUSE)
       (define stamps (file-stamps (files)))
       (cond
         [(changed? known stamps) (loop stamps #t)]
         [else
          (when moving? (act))
          (loop stamps #f)])))))

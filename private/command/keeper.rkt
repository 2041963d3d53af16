#lang racket/base
;; What outlives a render that is not finished: its checkpoint beside the output, and part files.
(require file/sha1 racket/list setup/getinfo "line.rkt"
         "../render/film-file.rkt" "../render/digest.rkt" "../render/film.rkt" "../render/pixel.rkt"
         "../render/job.rkt" "../render/passes.rkt" "../render/render.rkt" "../image/write.rkt"
         "../image/source.rkt" "unfinished.rkt")

(provide render-settings check-same-render make-keeper write-part)

;; render-settings : pairs of a word and a value that tell one render from another. path: the scene's
;; file. options: more such pairs, of what the user asked for.
(define (render-settings word path world camera options)
  (append
   (list (cons "version" (package-version))
         (cons "Racket version" (version))
         (cons "scene" word))
   options
   (list (cons "scene's content"
               (content-digest (list world camera) (lambda () (file-sum path)))))))

(define (package-version)
  (define info (get-info '("raytrace")))
  (format "~a" (and info (info 'version))))

(define (file-sum path) (call-with-input-file path sha1-bytes))

;; check-same-render : raises exn:fail:user with one line that names the file and the first thing that
;; is not as in the settings expected.
(define (check-same-render file what found expected)
  (for ([pair (in-list expected)])
    (define other (assoc (car pair) found))
    (unless (and other (equal? (cdr other) (cdr pair)))
      (raise-user-error
       (if (equal? (car pair) "scene's content")
           (format "~a: expected ~a, found one with another scene's content" file what)
           (format "~a: expected ~a, found another ~a: ~a, not ~a" file what (car pair)
                   (value-text (and other (cdr other))) (value-text (cdr pair))))))))

(define (value-text value)
  (cond [(not value) "none"]
        [(and (list? value) (= (length value) 2)) (format "~ax~a" (car value) (cadr value))]
        [else (one-line (format "~a" value))]))

;; ----------------------------------------------------------------------------------------------

;; make-keeper : a keeper of the checkpoint beside the output, written every so many seconds.
(define (make-keeper output settings part seconds)
  (define checkpoint (string-append output ".checkpoint"))
  (define (save progress #:locked? [locked? #f])
    (checkpoint-save checkpoint settings part progress #:locked? locked?))
  (keeper checkpoint
          (lambda (progress) (checkpoint-load! checkpoint settings part progress))
          (lambda (progress) (save progress #:locked? #t))
          (lambda (progress use) (call-with-saver seconds (lambda () (when (progress) (save (progress)))) use))
          (lambda () (checkpoint-delete checkpoint))))

(define (new-path checkpoint) (string-append checkpoint ".new"))

;; checkpoint-load! : goes on from the checkpoint, if there is one, in a render that starts.
(define (checkpoint-load! checkpoint settings part progress)
  (when (file-exists? checkpoint)
    (define what "a checkpoint of this render")
    (define head (film-file-header checkpoint what))
    (unless (eq? (header-kind head) 'checkpoint)
      (raise-user-error (format "~a: expected ~a, found a part" checkpoint what)))
    (check-same-render checkpoint what (header-settings head) settings)
    (unless (equal? part (header-part head))
      (raise-user-error (format "~a: expected ~a, found another part" checkpoint what)))
    (define target (Progress-target progress))
    (define tiles
      (film-file-load! checkpoint what (Job-tiling (Progress-job progress)) target))
    (when (Target-errors target)
      (for ([tile (in-list tiles)]) (bytes-set! (Progress-skip progress) tile 1)))
    ((Passes-resume! (Progress-passes progress)) (header-state head))))

;; checkpoint-save : writes what is done, whole or not at all; an older checkpoint stays where that fails.
;; Returns whether it was written. locked?: whether the film is not being planned anew meanwhile.
(define (checkpoint-save checkpoint settings part progress #:locked? [locked? #f])
  (define lock (Progress-lock progress))
  (define passes (Progress-passes progress))
  (define fresh (new-path checkpoint))
  (define (write-film out)
    (film-file-write out 'checkpoint settings part ((Passes-state passes))
                     (Job-tiling (Progress-job progress)) (Progress-target progress)))
  (define (discard) (when (file-exists? fresh) (delete-file fresh)))
  (with-handlers ([exn:fail? (lambda (e)
                               (with-handlers ([exn:fail? void]) (discard))
                               (picture-error checkpoint "cannot be written (~a)" (error-reason e)))])
    (define whole?
      (call-with-output-file fresh #:exists 'truncate/replace
        (lambda (out)
          (define (write-whole) (and (positive? ((Passes-count passes))) (write-film out)))
          (if locked? (write-whole) (call-with-semaphore lock write-whole)))))
    (if whole?
        (rename-file-or-directory fresh checkpoint #t)
        (discard))
    whole?))

(define (checkpoint-delete checkpoint)
  (for ([path (in-list (list checkpoint (new-path checkpoint)))])
    (with-handlers ([exn:fail:filesystem? void])
      (when (file-exists? path) (delete-file path)))))

;; The part of the time that may go into checkpoints.
(define SHARE 0.02)

;; call-with-saver : the values of (use), while a thread calls save every so many seconds, or less often
;; where writing takes long. A save that fails is told in one line, and tried again.
(define (call-with-saver seconds save use)
  (define (now) (/ (current-inexact-monotonic-milliseconds) 1000.0))
  (define saver
    (thread
     (lambda ()
       (let loop ([pause seconds] [told? #f])
         (sleep pause)
         (define start (now))
         (define failure
           (with-handlers ([exn:fail? exn-message]) (save) #f))
         (when (and failure (not told?))
           (eprintf "raytrace: ~a\n" (one-line failure)))
         (loop (max seconds (/ (- (now) start) SHARE)) (or told? (and failure #t)))))))
  (dynamic-wind void use (lambda () (kill-thread saver))))

;; ----------------------------------------------------------------------------------------------

;; write-part : the tiles of a part that is done, in a file.
(define (write-part path settings part progress)
  (define write-film
    (lambda (out)
      (film-file-write out 'part settings part ((Passes-state (Progress-passes progress)))
                       (Job-tiling (Progress-job progress)) (Progress-target progress))))
  (call-with-whole-file path write-film))

#lang racket/base
;; What one explores with, at a prompt: pictures changed, shown and handed to other libraries, worlds
;; in a window, and pixels explained. Each is loaded when it is first called.
(require racket/lazy-require)

(provide Image-crop Image-scale Image-exposed Image-tone Image-false-color Image-error-map
         Images-side-by-side Image->flomap flomap->Image Image->bitmap Image->pict
         Image-difference Image-compare Comparison? Comparison-rmse Comparison-rmse1
         Comparison-relative-mse Comparison-bias Comparison-psnr Comparison-worst-x
         Comparison-worst-y Comparison-worst-difference
         show view explain Explanation? Explanation-color Explanation-standard-error Explanation-rays
         Explanation-sources Explanation-depths Explanation-paths World-problems)

(lazy-require ["image/edit.rkt" (Image-crop Image-scale Image-exposed Image-tone
                                 Image-false-color Image-error-map Images-side-by-side)]
              ["image/compare.rkt" (Image-difference Image-compare Comparison? Comparison-rmse
                                    Comparison-rmse1 Comparison-relative-mse Comparison-bias
                                    Comparison-psnr Comparison-worst-x Comparison-worst-y
                                    Comparison-worst-difference)]
              ["image/show.rkt" (show)]
              ["image/bridge.rkt" (Image->flomap flomap->Image Image->bitmap Image->pict)]
              ["render/explain.rkt" (explain Explanation? Explanation-color
                                     Explanation-standard-error Explanation-rays
                                     Explanation-sources Explanation-depths Explanation-paths)]
              ["view/view.rkt" (view)]
              ["render/problems.rkt" (World-problems)])

#include "calibration/lens/calibrate_lens.h"
#include "tests/support/boards.h"
#include <cstdio>
#include <cstdlib>
#include <random>
#include <Eigen/Dense>
#include <gtest/gtest.h>
namespace alltact {
namespace {
int env(const char* n, int d) { return getenv(n) ? atoi(getenv(n)) : d; }
TEST(RenderedBoards, Scratch) {
  const CameraParameters truth = made::board_lens(env("FISH",0)?CameraModel::kFisheye:CameraModel::kBrown);
  const Camera camera = Camera::create(truth).value();
  const made::BoardPainter painter(camera);
  for (const BoardPattern pattern : {BoardPattern::kDots, BoardPattern::kChessboard}) {
    Board board = made::chessboard(8, 6, 4);
    board.pattern = pattern;
    const double part = env("PART",50)/100.0; if (getenv("ONLY") && env("ONLY",0) != (int)pattern) continue;
    LensSettings st; st.model = truth.model; const int N = (int)lens_numbers(truth).size();
    double nees = 0, sq = 0, s0 = 0; int n = 0, runs = env("RUNS", 10);
    Eigen::VectorXd each = Eigen::VectorXd::Zero(N), bias = each;
    double ex=0, ey=0, exx=0, eyy=0, cross=0; long dots=0, pairs=0; double sig=0;
    for (int run = 0; run < runs; ++run) {
      std::mt19937 random(500 + run);
      const auto scene = made::board_scene(camera, board, env("VIEWS",10), env("TILT",40), 0, random);
      std::vector<BoardView> views;
      for (std::size_t i = 0; i < scene.poses.size(); ++i) {
        auto picture = painter.paint(scene.poses[i], [&](double x, double y) {
          const double light = 1 + env("GRAD",0)*0.01*(x-14)/14 + env("GRAD",0)*0.005*(y-10)/10; return light * (pattern == BoardPattern::kDots ? made::dots_ink(board, part, x, y) : made::chessboard_ink(board, x, y)); }, 1000*run+i);
        if (getenv("NOISE")) { cv::Mat f, nz(picture.size(), CV_32F); cv::RNG r(77*run+i); r.fill(nz, cv::RNG::NORMAL, 0, env("NOISE",0)); picture.convertTo(f, CV_32F); if (getenv("BLUR")) cv::GaussianBlur(f, f, {}, env("BLUR",0)*0.1); f += nz; f.convertTo(picture, CV_8U); }
        auto view = find_board(picture, board);
        if (!view) continue;
        view->name = scene.views[i].name;
        // may come in another order: match by nearest
        const BoardView fixed = pattern == BoardPattern::kDots ? without_dot_bias(*view, truth, scene.poses[i], 0.5*part*4) : *view;
        std::vector<Eigen::Vector2d> err(48, Eigen::Vector2d::Zero());
        BoardView ordered = *view;
        for (std::size_t k = 0; k < 48; ++k) {
          std::size_t best = 0; double d = 1e9;
          for (std::size_t m = 0; m < 48; ++m) if (double q = (fixed.pixels[m] - scene.views[i].pixels[k]).norm(); q < d) d = q, best = m;
          BoardView f2 = ordered; 
          ordered.pixels[k] = view->pixels[best];
        }
        const BoardView ord_fixed = pattern == BoardPattern::kDots ? without_dot_bias(ordered, truth, scene.poses[i], 0.5*part*4) : ordered;
        for (std::size_t k = 0; k < 48; ++k) err[k] = ord_fixed.pixels[k] - scene.views[i].pixels[k];
        if (getenv("WORST")) for (int k = 0; k < 48; ++k) if (err[k].norm() > 0.06) printf("run %d view %d dot %d at %.1f %.1f err %.3f %.3f tilt %.1f\n", run, (int)i, k, scene.views[i].pixels[k].x(), scene.views[i].pixels[k].y(), err[k].x(), err[k].y(), scene.poses[i].turn.norm()*57.3);
        for (int k = 0; k < 48; ++k) { auto e = err[k]; ex+=e.x(); ey+=e.y(); exx+=e.x()*e.x(); eyy+=e.y()*e.y(); ++dots;
          if (k%8 < 7) { cross += err[k].dot(err[k+1]); pairs+=2; } 
          if (k<40) { cross += err[k].dot(err[k+8]); pairs+=2;} }
        views.push_back(ordered);
      }
      const auto found = calibrate_lens(views, camera.size(), st, {});
      if (!found) { printf("no lens %s\n", found.error().sentence().c_str()); continue; }
      const Eigen::VectorXd error = lens_numbers(found->fit.lens) - lens_numbers(truth);
      const Eigen::MatrixXd& c = found->fit.covariance;
      if (c.diagonal().minCoeff() <= 0) { printf("fewer coefficients\n"); continue; }
      const Eigen::VectorXd scale = c.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd z = scale.cwiseProduct(error);
      const Eigen::MatrixXd corr = scale.asDiagonal() * c * scale.asDiagonal();
      const double one = z.dot(corr.ldlt().solve(z)) / N;
      nees += one; sq += one*one; ++n; each += z.cwiseAbs2(); bias += z; sig += found->fit.sigma_px; s0 += found->fit.sd(0);
    }
    printf("%s nees %.3f +- %.3f n %d sigma_fit %.4f sd fx %.3f; err mean %.4f %.4f rms %.4f %.4f corr neighbours %.3f\n", pattern==BoardPattern::kDots?"dots":"chess", nees/n, std::sqrt((sq/n-nees*nees/n/n)/n), n, sig/n, s0/n, ex/dots, ey/dots, std::sqrt(exx/dots), std::sqrt(eyy/dots), cross/pairs/(0.5*(exx+eyy)/dots));
    printf("  each:"); for (int i=0;i<N;++i) printf(" %.2f", each[i]/n); printf("\n  bias:"); for (int i=0;i<N;++i) printf(" %.2f", bias[i]/n); printf("\n");
  }
}
}  // namespace
}  // namespace alltact

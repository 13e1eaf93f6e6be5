% Times one evaluation of the Bouc-Wen law with ode45, written as a MATLAB user would write it. The time is that of the
% fastest of three evaluations at the default tolerances. Prints one JSON object with the objective at the default and
% at tight tolerances.
% Usage: octave_ode45.m RECORD.csv alpha Ke A beta n gamma
1;

function dz = slope(t, z, t0, dt, rate, A, beta, n, gamma)
  v = rate(min(max(floor((t - t0) / dt) + 1, 1), numel(rate)));
  dz = A * v - beta * abs(v) * z * abs(z)^(n - 1) - gamma * v * abs(z)^n;
end

function of = objective(t, x, measured, p, options)
  t0 = t(1);
  dt = (t(end) - t0) / (numel(t) - 1);
  rate = diff(x) ./ diff(t);
  weight = ([diff(t); 0] + [0; diff(t)]) / 2 / (t(end) - t0) / std(measured, 1);
  % z starts at 1e-12, because at z = 0 the law contains the power 0^(n-1).
  [~, z] = ode45(@(t, z) slope(t, z, t0, dt, rate, p(3), p(4), p(5), p(6)), t, 1e-12, options);
  force = p(1) * p(2) * x + (1 - p(1)) * p(2) * z;
  of = weight' * abs(measured - force);
end

words = argv();
record = dlmread(words{1}, ",", 1, 0);
t = record(:, 1); x = record(:, 2); measured = record(:, 3);
p = cellfun(@str2double, words(2:7));
seconds = Inf; cpu = Inf;
for repetition = 1:3
  start = tic(); start_cpu = cputime();
  timed = objective(t, x, measured, p, odeset());
  seconds = min(seconds, toc(start)); cpu = min(cpu, cputime() - start_cpu);
end
tight = objective(t, x, measured, p, odeset("RelTol", 1e-9, "AbsTol", 1e-9));
printf(["{\"seconds\": %.6f, \"cpu\": %.6f, \"evaluations\": 1, \"samples\": %d, " ...
        "\"objective\": %.17g, \"default_objective\": %.17g}\n"], seconds, cpu, numel(t), tight, timed);

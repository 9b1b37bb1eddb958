namespace ErrorMatching.Freeform;

/// <summary>Finds a local minimum of a function of one variable by parabolic interpolation and golden sections (Brent, Algorithms for
/// Minimization without Derivatives, 1973, chapter 5).</summary>
internal static class LineMinimum
{
    private const int MostEvaluations = 60;

    /// <summary>Returns a local minimum between two places.</summary>
    /// <param name="function">The function to minimize.</param>
    /// <param name="low">Start of the range.</param>
    /// <param name="high">End of the range.</param>
    /// <param name="tolerance">Required accuracy of the place.</param>
    public static double Find(Func<double, double> function, double low, double high, double tolerance)
    {
        var golden = (3 - Math.Sqrt(5)) / 2;
        var best = low + (golden * (high - low));
        var (second, third) = (best, best);
        var least = function(best);
        var (atSecond, atThird) = (least, least);
        var (step, before) = (0.0, 0.0);
        for (var used = 1; used < MostEvaluations && high - low > 2 * tolerance; used++)
        {
            var middle = (low + high) / 2;
            var r = (best - second) * (least - atThird);
            var q = (best - third) * (least - atSecond);
            var p = ((best - third) * q) - ((best - second) * r);
            q = 2 * (q - r);
            (p, q) = q > 0 ? (-p, q) : (p, -q);
            var isParabola = double.IsFinite(p) && Math.Abs(p) < Math.Abs(q * before / 2) && p > q * (low - best) && p < q * (high - best);
            (before, step) = isParabola ? (step, p / q) : Golden();
            if (isParabola && (best + step - low < tolerance || high - best - step < tolerance))
            {
                step = Math.CopySign(tolerance, middle - best);
            }

            if (Math.Abs(best - middle) <= (2 * tolerance) - ((high - low) / 2))
            {
                break;
            }

            var next = best + (Math.Abs(step) >= tolerance ? step : Math.CopySign(tolerance, step));
            var value = function(next);
            if (value <= least)
            {
                (low, high) = next >= best ? (best, high) : (low, best);
                (third, atThird, second, atSecond, best, least) = (second, atSecond, best, least, next, value);
                continue;
            }

            (low, high) = next < best ? (next, high) : (low, next);
            if (value <= atSecond || second == best)
            {
                (third, atThird, second, atSecond) = (second, atSecond, next, value);
            }
            else if (value <= atThird || third == best || third == second)
            {
                (third, atThird) = (next, value);
            }

            (double, double) Golden()
            {
                var whole = best >= middle ? low - best : high - best;
                return (whole, golden * whole);
            }
        }

        return best;
    }
}

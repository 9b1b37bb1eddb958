using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Moves the breaks of a polynomial to minimize the sum of squares with fixed terms: Gauss-Newton with step halving.</summary>
internal static class BreakRefinement
{
    private const int MostSteps = 30;

    /// <summary>The last step leaves more than this share of the sum of squares: the criterion then changes by far less than 1.</summary>
    private const double LeastShare = 1 - 1e-5;

    /// <summary>Returns the model with its optimized breaks.</summary>
    public static PolynomialModel Run(PolynomialModel model)
    {
        for (var step = 0; step < MostSteps; step++)
        {
            if (Moves(model) is not { } moves)
            {
                return model;
            }

            var better = (PolynomialModel?)null;
            var size = 0.0;
            for (var share = 1.0; share > 0.03 && better is null; share /= 2)
            {
                var moved = PolynomialModel.Fit(model.Data, Moved(model, moves, share));
                size = moves.Values.Max(Math.Abs) * share;
                better = moved?.SquareSum < model.SquareSum ? moved : null;
            }

            if (better is null || size < 1e-15 || better.SquareSum > model.SquareSum * LeastShare)
            {
                return better ?? model;
            }

            model = better;
        }

        return model;
    }

    /// <summary>The Gauss-Newton step of each break; null if there are no breaks or they are not determined.</summary>
    private static Dictionary<(bool AlongU, double At), double>? Moves(PolynomialModel model)
    {
        // With a single line beyond it, the position and size of a break cannot be distinguished, so it is not moved.
        var (linesU, linesV) = model.Data.LinePlaces();
        (bool AlongU, double At)[] breaks = [
            .. Between(model.BreaksU, linesU).Select(b => (true, b)), .. Between(model.BreaksV, linesV).Select(b => (false, b))];
        if (breaks.Length == 0)
        {
            return null;
        }

        var columns = Term.Over(model.Terms, model.Data.U, model.Data.V).Concat(breaks.Select(b => Slope(model, b.AlongU, b.At))).ToList();
        if (LeastSquares.Solve(columns, model.Data.Z) is not { } fit)
        {
            return null;
        }

        var moves = new Dictionary<(bool, double), double>();
        for (var k = 0; k < breaks.Length; k++)
        {
            moves[breaks[k]] = fit.Coefficients[model.Terms.Count + k];
        }

        return moves;
    }

    private static IEnumerable<double> Between(IReadOnlyList<double> breaks, double[] lines) =>
        breaks.Where(b => lines.Length > 3 && b >= lines[1] && b <= lines[^2]);

    /// <summary>Derivative of the model's values with respect to the position of a break.</summary>
    private static double[] Slope(PolynomialModel model, bool alongU, double at)
    {
        var result = new double[model.Data.Count];
        for (var k = 0; k < model.Terms.Count; k++)
        {
            var term = model.Terms[k];
            var (one, other) = alongU ? (term.U, term.V) : (term.V, term.U);
            if (one.Break != at)
            {
                continue;
            }

            for (var i = 0; i < result.Length; i++)
            {
                var (t, s) = alongU ? (model.Data.U[i], model.Data.V[i]) : (model.Data.V[i], model.Data.U[i]);
                if (t > at)
                {
                    // d/dxi of ((t - xi) / (1 - xi))^p.
                    var x = (t - at) / (1 - at);
                    result[i] += model.Coefficients[k] * other.At(s) * one.Power * Elementary.Pow(x, one.Power - 1) * (x - 1) / (1 - at);
                }
            }
        }

        return result;
    }

    private static Term[] Moved(PolynomialModel model, Dictionary<(bool AlongU, double At), double> moves, double share)
    {
        var (linesU, linesV) = model.Data.LinePlaces();
        return [.. model.Terms.Select(t => new Term(Move(t.U, true, linesU), Move(t.V, false, linesV)))];

        AxisFunction Move(AxisFunction function, bool alongU, double[] lines) =>
            function.Break is { } at && moves.TryGetValue((alongU, at), out var move)
            ? function with { Break = Math.Clamp(at + (move * share), lines[1], lines[^2]) }
            : function;
    }
}

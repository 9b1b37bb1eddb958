namespace ErrorMatching.Freeform;

/// <summary>Finds places where the second derivative jumps. It scans a one-sided square at every place over a low-degree polynomial,
/// reselects the terms with the most promising places, and moves the breaks by Gauss-Newton until the residual stops falling.</summary>
/// <remarks>Each side of a break needs at least two lines: with one, many breaks could explain any value. Breaks follow grid lines;
/// oblique ones are not found.</remarks>
internal sealed class BreakSearch
{
    /// <summary>Minimum reduction of the criterion by a break.</summary>
    private const double LeastGain = 10;

    private const int PlacesPerCell = 8;
    private const int MostBreaks = 4;

    /// <summary>Number of lines in one direction that suffice to find breaks.</summary>
    private const int EnoughLines = 15;

    private readonly FieldData _all;
    private readonly FieldData _data;
    private readonly (double[] U, double[] V) _lines;

    public BreakSearch(FieldData data)
    {
        _all = data;
        _data = data.Thinned(EnoughLines);
        _lines = _data.LinePlaces();
    }

    /// <summary>Returns the model without breaks, and those whose breaks improve the criterion enough over all with fewer.</summary>
    public IReadOnlyList<PolynomialModel> Run()
    {
        var model = PolynomialModel.Choose(_all, [], []);
        var found = new List<PolynomialModel> { model };
        if (_data != _all)
        {
            model = PolynomialModel.Choose(_data, [], []);
        }

        // One of two breaks may explain nothing alone, so the search continues after one failure.
        var failures = 0;
        for (var count = 0; count < MostBreaks && failures < 2 && !found[^1].IsExact && Extend(model) is { } next; count++)
        {
            model = next;
            var full = _data == _all ? model : OverAll(model);
            if (full.Criterion < found[^1].Criterion - LeastGain)
            {
                found.Add(full);
                failures = 0;
            }
            else
            {
                failures++;
            }
        }

        return found;
    }

    /// <summary>Selects the terms over all values, with the breaks of a low-degree polynomial. Moving others takes too long.</summary>
    private PolynomialModel OverAll(PolynomialModel model)
    {
        var low = PolynomialModel.Fit(_all, Low(model.BreaksU, model.BreaksV)) is { } fit ? BreakRefinement.Run(fit) : model;
        return PolynomialModel.Choose(_all, low.BreaksU, low.BreaksV);
    }

    /// <summary>Selects only terms up to squares, with the breaks of a model. A quadratic on each side may suffice, and higher terms would
    /// only follow noise.</summary>
    public static PolynomialModel Squares(PolynomialModel model) =>
        BreakRefinement.Run(PolynomialModel.Choose(model.Data, model.BreaksU, model.BreaksV, 2));

    private PolynomialModel? Extend(PolynomialModel model) =>
        Places(model).Select(place => Try(model, place.AlongU, place.At)).OfType<PolynomialModel>().MinBy(m => m.Criterion);

    private PolynomialModel? Try(PolynomialModel model, bool alongU, double at)
    {
        double[] u = alongU ? [.. model.BreaksU, at] : [.. model.BreaksU];
        double[] v = alongU ? [.. model.BreaksV] : [.. model.BreaksV, at];
        var wanted = u.Length + v.Length;
        if (PolynomialModel.Fit(_data, Low(u, v)) is not { } low)
        {
            return null;
        }

        // Optimize the breaks of a low-degree polynomial first. A high-degree one would follow the data regardless of its breaks.
        low = BreakRefinement.Run(low);
        (u, v) = ([.. low.BreaksU], [.. low.BreaksV]);
        PolynomialModel? result = null;
        for (var round = 0; round < 2; round++)
        {
            var chosen = BreakRefinement.Run(PolynomialModel.Choose(_data, u, v));
            if (chosen.BreaksU.Count + chosen.BreaksV.Count < wanted || chosen.Criterion >= (result?.Criterion ?? double.PositiveInfinity))
            {
                break;
            }

            result = chosen;
            (u, v) = ([.. chosen.BreaksU], [.. chosen.BreaksV]);
        }

        return result;
    }

    /// <summary>Local minima of the residual of a biquadratic with the model's breaks and one more, deepest first.</summary>
    private List<BreakPlace> Places(PolynomialModel model)
    {
        var basis = new List<double[]>();
        var rest = (double[])_data.Z.Clone();
        foreach (var term in Low(model.BreaksU, model.BreaksV))
        {
            if (Unit(term.Over(_data.U, _data.V), basis) is { } unit)
            {
                basis.Add(unit);
                LeastSquares.Remove(rest, unit);
            }
        }

        // The four deepest; the first of equal ones.
        List<BreakPlace> minima = [.. Minima(true, _lines.U, basis, rest), .. Minima(false, _lines.V, basis, rest)];
        var places = new List<BreakPlace>();
        while (places.Count < 4 && minima.MinBy(m => m.Sum) is { } deepest)
        {
            places.Add(deepest);
            minima.Remove(deepest);
        }

        return places;
    }

    private static Term[] Low(IReadOnlyList<double> breaksU, IReadOnlyList<double> breaksV) =>
        [.. from a in UpToSquare(breaksU) from b in UpToSquare(breaksV) select new Term(a, b)];

    private static IEnumerable<AxisFunction> UpToSquare(IReadOnlyList<double> breaks) =>
        AxisFunction.Hierarchy(2, breaks).Where(f => f.Power <= 2);

    private List<BreakPlace> Minima(bool alongU, double[] lines, List<double[]> basis, double[] rest)
    {
        var scanned = new List<BreakPlace>();
        var places = lines.Length > 60 ? 2 : PlacesPerCell;
        for (var cell = 1; cell + 2 < lines.Length; cell++)
        {
            for (var k = 0; k < places; k++)
            {
                var at = lines[cell] + ((lines[cell + 1] - lines[cell]) * (k + 0.5) / places);
                scanned.Add(new(alongU, at, Left(alongU, at, basis, rest)));
            }
        }

        return [
            .. scanned.Where((s, k) => (k == 0 || s.Sum <= scanned[k - 1].Sum) && (k + 1 == scanned.Count || s.Sum <= scanned[k + 1].Sum))];
    }

    private double Left(bool alongU, double at, List<double[]> basis, double[] rest)
    {
        var sum = LeastSquares.Product(rest, rest);
        var all = new List<double[]>(basis);
        for (var power = 0; power <= 2; power++)
        {
            var (one, other) = (new AxisFunction(2, at), new AxisFunction(power));
            if (Unit((alongU ? new Term(one, other) : new Term(other, one)).Over(_data.U, _data.V), all) is { } unit)
            {
                all.Add(unit);
                var part = LeastSquares.Product(rest, unit);
                sum -= part * part;
            }
        }

        return sum;
    }

    private static double[]? Unit(double[] column, List<double[]> basis)
    {
        var before = LeastSquares.Product(column, column);
        foreach (var unit in basis.Concat(basis))
        {
            LeastSquares.Remove(column, unit);
        }

        var left = LeastSquares.Product(column, column);
        if (left <= before * 1e-20)
        {
            return null;
        }

        LeastSquares.Scale(column, 1 / Math.Sqrt(left));
        return column;
    }

    /// <summary>A candidate for a break.</summary>
    /// <param name="AlongU">True for a break in u.</param>
    /// <param name="At">Its parameter.</param>
    /// <param name="Sum">The remaining sum of squares.</param>
    private sealed record BreakPlace(bool AlongU, double At, double Sum);
}

namespace ErrorMatching.Freeform;

/// <summary>Values over two parameters from -1 to 1, with the grid lines on which they were measured.</summary>
/// <param name="I">Index of each value along its curve.</param>
/// <param name="J">Index of its curve.</param>
/// <param name="U">First parameter of each value.</param>
/// <param name="V">Second parameter.</param>
/// <param name="Z">The values.</param>
internal sealed record FieldData(int[] I, int[] J, double[] U, double[] V, double[] Z)
{
    /// <summary>Maximum number of lines left out in one direction, evenly chosen. More would cost time without changing the mean.</summary>
    private const int MostLinesOut = 12;

    private const int FewLinesOut = 4;

    private const int ManyValues = 1000;

    /// <summary>Number of lines in one direction that suffice to find a model's parameters. The final fit uses all lines.</summary>
    public const int EnoughLines = 20;

    private const int MostPlacesBetween = 400;

    /// <summary>The errors of samples over their parameters, each scaled to the range from -1 to 1.</summary>
    public static FieldData Of(IReadOnlyList<ErrorSample> samples)
    {
        var (u, v) = (ParameterRange.Of(samples.Select(s => s.U)), ParameterRange.Of(samples.Select(s => s.V)));
        return new(
            [.. samples.Select(s => s.I)],
            [.. samples.Select(s => s.J)],
            [.. samples.Select(s => u.ToUnit(s.U))],
            [.. samples.Select(s => v.ToUnit(s.V))],
            [.. samples.Select(s => s.ErrorMm)]);
    }

    public int Count => Z.Length;

    /// <summary>The curves of constant j, ascending, as indices of their values, along each curve.</summary>
    /// <remarks>Values come in the order of measuring, which goes to and fro. Evenly chosen values of a curve must lie on the lines of
    /// those of other curves.</remarks>
    public int[][] Curves { get; } = Array.ConvertAll(Groups(J), curve => Along(curve, I));

    /// <summary>The lines across the curves: lines of constant i if all curves have the same numbers, otherwise bands along u with one
    /// value per curve on average.</summary>
    public int[][] Crossings => _crossings ??= IsRectangular ? Groups(I) : Bands();

    private int[][]? _crossings;

    /// <summary>True if all curves have the same numbers i.</summary>
    public bool IsRectangular { get; } = Rectangular(I, J);

    /// <summary>The inner lines of both directions to leave out in turn, each with the remaining values. The outermost lines stay, because
    /// a fit without them would have to extrapolate.</summary>
    public IReadOnlyList<(int[] Line, FieldData Stored)> LinesOut =>
        _linesOut ??= [.. Inner(Curves).Concat(Inner(Crossings)).Select(line => (line, Without(line)))];

    /// <summary>True if the values are a part of many, chosen to save time. Of them, few lines are left out.</summary>
    private bool IsThinned { get; init; }

    private (int[], FieldData)[]? _linesOut;

    private FieldData Without(int[] line)
    {
        var gone = new HashSet<int>(line);
        var kept = Only([.. Enumerable.Range(0, Count).Where(k => !gone.Contains(k))]);
        _ = (kept.Grid, kept.Crossings);
        return kept;
    }

    /// <summary>The rectangular grid of the values; null if they do not form one.</summary>
    public SampleGrid? Grid
    {
        get
        {
            if (!_gridSought)
            {
                (_grid, _gridSought) = (SampleGrid.Of(this), true);
            }

            return _grid;
        }
    }

    private SampleGrid? _grid;
    private bool _gridSought;

    /// <summary>The values on evenly chosen lines, at most this number in each direction, always including the outermost.</summary>
    public FieldData Thinned(int lines)
    {
        if (Curves.Length <= lines && Array.TrueForAll(Curves, c => c.Length <= lines))
        {
            return this;
        }

        var chosen = Chosen(Curves.Length, lines).SelectMany(c => Chosen(Curves[c].Length, lines).Select(k => Curves[c][k]));
        return Only([.. chosen]) with { IsThinned = true };
    }

    private static int[] Chosen(int count, int most) =>
        count <= most
            ? [.. Enumerable.Range(0, count)]
            : [.. Enumerable.Range(0, most).Select(k => (int)((long)k * (count - 1) / (most - 1)))];

    /// <summary>The values with the given indices.</summary>
    public FieldData Only(int[] kept) => new(Pick(I, kept), Pick(J, kept), Pick(U, kept), Pick(V, kept), Pick(Z, kept));

    /// <summary>The same places with other values.</summary>
    public FieldData With(double[] values) => new(I, J, U, V, values);

    /// <summary>The mean parameter of each line, ascending: crossings along u and curves along v.</summary>
    public (double[] U, double[] V) LinePlaces() =>
        ([.. Crossings.Select(line => line.Average(k => U[k])).Order()], [.. Curves.Select(line => line.Average(k => V[k])).Order()]);

    /// <summary>Places halfway between neighboring values, along and across the curves; a few hundred at most.</summary>
    public (double[] U, double[] V) Between => _between ??= Halfway();

    private (double[] U, double[] V)? _between;

    private static T[] Pick<T>(T[] from, int[] kept) => Array.ConvertAll(kept, k => from[k]);

    private IEnumerable<int[]> Inner(int[][] lines)
    {
        var inner = lines.Length - 2;
        var count = Math.Min(inner, IsThinned || Count > ManyValues ? FewLinesOut : MostLinesOut);
        for (var k = 0; k < count; k++)
        {
            yield return lines[1 + (int)(((2L * k) + 1) * inner / (2 * count))];
        }
    }

    private (double[] U, double[] V) Halfway()
    {
        var (u, v) = (new List<double>(), new List<double>());
        for (var c = 0; c < Curves.Length; c++)
        {
            for (var k = 0; k < Curves[c].Length; k++)
            {
                var here = Curves[c][k];
                var next = k + 1 < Curves[c].Length ? Curves[c][k + 1] : here;
                var across = c + 1 < Curves.Length ? Nearest(Curves[c + 1], U[next]) : next;
                foreach (var other in (ReadOnlySpan<int>)[next, across])
                {
                    u.Add((U[here] + U[other]) / 2);
                    v.Add((V[here] + V[other]) / 2);
                }
            }
        }

        var step = Math.Max(1, u.Count / MostPlacesBetween);
        return ([.. u.Where((_, k) => k % step == 0)], [.. v.Where((_, k) => k % step == 0)]);
    }

    private int Nearest(int[] curve, double u)
    {
        var best = curve[0];
        foreach (var k in curve)
        {
            best = Math.Abs(U[k] - u) < Math.Abs(U[best] - u) ? k : best;
        }

        return best;
    }

    // Values at the same place keep the given order.
    private static int[] Along(int[] curve, int[] i)
    {
        var isAlong = true;
        for (var k = 0; k + 1 < curve.Length && isAlong; k++)
        {
            isAlong = i[curve[k]] <= i[curve[k + 1]];
        }

        return isAlong ? curve : [.. curve.OrderBy(k => i[k])];
    }

    private static int[][] Groups(int[] numbers) =>
        [.. Enumerable.Range(0, numbers.Length).GroupBy(k => numbers[k]).OrderBy(g => g.Key).Select(g => g.ToArray())];

    private static bool Rectangular(int[] i, int[] j)
    {
        var rows = Groups(j);
        var first = rows.Length == 0 ? [] : rows[0].Select(k => i[k]).Order().ToArray();
        return rows.All(row => row.Select(k => i[k]).Order().SequenceEqual(first));
    }

    private int[][] Bands()
    {
        var order = Enumerable.Range(0, Count).OrderBy(k => U[k]).ThenBy(k => V[k]).ToArray();
        var bands = Math.Max(1, (int)Math.Round((double)Count / Curves.Length));
        return [.. Enumerable.Range(0, bands).Select(b => order[(int)((long)b * Count / bands)..(int)((long)(b + 1) * Count / bands)])];
    }
}

namespace ErrorMatching.Freeform;

/// <summary>A function of two parameters from -1 to 1 that was fitted to values on a grid.</summary>
internal abstract class FieldModel(FieldData data)
{
    private double? _lineOut;
    private IReadOnlyList<(int Number, double Difference)>? _leftOut;

    public FieldData Data => data;

    public abstract FieldModelKind Kind { get; }

    /// <summary>Parameters u at which the second derivative of the model jumps.</summary>
    public virtual IReadOnlyList<double> BreaksU => [];

    /// <summary>Parameters v at which the second derivative of the model jumps.</summary>
    public virtual IReadOnlyList<double> BreaksV => [];

    /// <summary>How many values the fit uses up: the trace of the matrix that takes measured to fitted values.</summary>
    public abstract double Freedom { get; }

    /// <summary>Standard deviation of the noise of one value, as the model sees it.</summary>
    public abstract double Noise { get; }

    public abstract double At(double u, double v);

    /// <summary>Variance of <see cref="At"/> for a given standard deviation of the noise of one value.</summary>
    public abstract double VarianceAt(double u, double v, double noise);

    /// <summary>The same kind of model, its terms and parameters kept, fitted to other values; null if they do not determine it.</summary>
    public abstract FieldModel? Refit(FieldData other);

    /// <summary>Degree along u of the spline that is the model, or comes close to it with few pieces.</summary>
    public abstract int DegreeU { get; }

    /// <summary>Degree along v.</summary>
    public abstract int DegreeV { get; }

    /// <summary>Where the pieces of the model meet along u, and how many derivatives go on there.</summary>
    public virtual IEnumerable<(double At, int Smoothness)> JoinsU => BreaksU.Select(at => (at, 1));

    /// <summary>Where the pieces of the model meet along v, and how many derivatives go on there.</summary>
    public virtual IEnumerable<(double At, int Smoothness)> JoinsV => BreaksV.Select(at => (at, 1));

    /// <summary>True if the model is a spline of these degrees and joins.</summary>
    public virtual bool IsSpline => true;

    /// <summary>Mean absolute difference of the values of left-out lines from the model fitted without their line; infinite if a line is needed, NaN if there are no lines to leave out.</summary>
    public double LineOut => _lineOut ??= Mean(LeaveLinesOut());

    /// <summary>What the model leaves of each value.</summary>
    public double[] Residuals()
    {
        var result = new double[data.Count];
        for (var k = 0; k < result.Length; k++)
        {
            result[k] = data.Z[k] - At(data.U[k], data.V[k]);
        }

        return result;
    }

    /// <summary>The difference of each left-out value, with its number; each value may be left out with both its lines. Found once, by one thread.</summary>
    public IReadOnlyList<(int Number, double Difference)> LeaveLinesOut()
    {
        if (_leftOut is not null)
        {
            return _leftOut;
        }

        var leftOut = new List<(int, double)>();
        foreach (var (line, kept) in data.LinesOut)
        {
            var model = Refit(kept);
            foreach (var k in line)
            {
                leftOut.Add((k, model is null ? double.PositiveInfinity : data.Z[k] - model.At(data.U[k], data.V[k])));
            }
        }

        return _leftOut = leftOut;
    }

    private static double Mean(IReadOnlyList<(int Number, double Difference)> differences)
    {
        var (sum, count) = (0.0, 0);
        foreach (var (_, difference) in differences)
        {
            (sum, count) = (sum + Math.Abs(difference), count + 1);
        }

        return count > 0 ? sum / count : double.NaN;
    }
}

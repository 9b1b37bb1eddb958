namespace ErrorMatching.Freeform;

/// <summary>A function of two parameters from -1 to 1, fitted to values on a grid.</summary>
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

    /// <summary>Degrees of freedom used by the fit: the trace of the matrix that maps measured to fitted values.</summary>
    public abstract double Freedom { get; }

    /// <summary>Standard deviation of the noise of one value, as the model estimates it.</summary>
    public abstract double Noise { get; }

    public abstract double At(double u, double v);

    /// <summary>Variance of <see cref="At"/> for a given noise standard deviation.</summary>
    public abstract double VarianceAt(double u, double v, double noise);

    /// <summary>Fits the same kind of model, with the same terms and parameters, to other values; null if undetermined.</summary>
    public abstract FieldModel? Refit(FieldData other);

    /// <summary>Degree along u of the spline that equals the model, or approximates it with few pieces.</summary>
    public abstract int DegreeU { get; }

    /// <summary>Degree along v.</summary>
    public abstract int DegreeV { get; }

    /// <summary>Where the pieces of the model meet along u, and the number of continuous derivatives there.</summary>
    public virtual IEnumerable<(double At, int Smoothness)> JoinsU => BreaksU.Select(at => (at, 1));

    /// <summary>Where the pieces of the model meet along v, and the number of continuous derivatives there.</summary>
    public virtual IEnumerable<(double At, int Smoothness)> JoinsV => BreaksV.Select(at => (at, 1));

    /// <summary>True if the model is a spline of these degrees and joins.</summary>
    public virtual bool IsSpline => true;

    /// <summary>Mean absolute difference between left-out values and the model fitted without their line; infinite if a line is needed,
    /// NaN if no line can be left out.</summary>
    public double LineOut => _lineOut ??= Mean(LeaveLinesOut());

    public double[] Residuals()
    {
        var result = new double[data.Count];
        for (var k = 0; k < result.Length; k++)
        {
            result[k] = data.Z[k] - At(data.U[k], data.V[k]);
        }

        return result;
    }

    /// <summary>The difference and index of each left-out value. A value may occur for both lines. Cached; not thread-safe.</summary>
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

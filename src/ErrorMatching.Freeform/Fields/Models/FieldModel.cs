namespace ErrorMatching.Freeform;

/// <summary>A function of two parameters from -1 to 1 that was fitted to values on a grid.</summary>
internal abstract class FieldModel(FieldData data)
{
    private double? _lineOut;

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

    /// <summary>Mean absolute difference of the values of left-out lines from the model fitted without their line; infinite if a line is needed, NaN if there are no lines to leave out.</summary>
    public double LineOut => _lineOut ??= LeaveLinesOut();

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

    private double LeaveLinesOut()
    {
        var (sum, count) = (0.0, 0);
        foreach (var line in data.LinesOut())
        {
            if (Refit(data.Without(line)) is not { } model)
            {
                return double.PositiveInfinity;
            }

            foreach (var k in line)
            {
                sum += Math.Abs(data.Z[k] - model.At(data.U[k], data.V[k]));
                count++;
            }
        }

        return count > 0 ? sum / count : double.NaN;
    }
}

namespace ErrorMatching.Freeform;

/// <summary>A field fitted to measured errors, with measures of its reliability. Lengths in millimeters.</summary>
/// <remarks>Beyond the outermost samples, the field continues straight for one mean line spacing and is then constant. Its uncertainty
/// grows accordingly. Breaks are found only along grid lines, with at least two lines on each side. An oblique break is not found; a spline
/// or process then rounds it off.</remarks>
public sealed class FittedField : ErrorField
{
    private readonly FieldModel _model;
    private readonly ParameterRange _u;
    private readonly ParameterRange _v;
    private readonly double _spaceU;
    private readonly double _spaceV;
    private readonly double _noise;

    internal FittedField(FieldModel model, ParameterRange u, ParameterRange v, double pointUncertaintyMm)
    {
        (_model, _u, _v) = (model, u, v);
        var data = model.Data;
        _spaceU = 2.0 / Math.Max(1, data.Crossings.Length - 1);
        _spaceV = 2.0 / Math.Max(1, data.Curves.Length - 1);
        _noise = Math.Max(model.Noise, pointUncertaintyMm);
        Residuals = Array.AsReadOnly(model.Residuals());
        ResidualStandardDeviationMm = Math.Sqrt(
            Residuals.Sum(r => r * r) / Math.Max(1, data.Count - Math.Min(data.Count - 1, model.Freedom)));
        BreaksU = [.. model.BreaksU.Select(u.FromUnit)];
        BreaksV = [.. model.BreaksV.Select(v.FromUnit)];
    }

    /// <summary>The kind of function that described the samples best.</summary>
    public FieldModelKind Kind => _model.Kind;

    /// <summary>Parameters u at which the second derivative of the field jumps, ascending.</summary>
    public IReadOnlyList<double> BreaksU { get; }

    /// <summary>Parameters v at which the second derivative of the field jumps, ascending.</summary>
    public IReadOnlyList<double> BreaksV { get; }

    /// <summary>Number of points to each wave of the field, in the direction in which there are fewer; infinite for a field without
    /// waves.</summary>
    internal double PointsPerWave => _model is not ProcessModel { Kernel: var kernel }
        ? double.PositiveInfinity
        : Math.PI * Math.Min(
            (_model.Data.Crossings.Length - 1) / Math.Abs(kernel.WaveU),
            (_model.Data.Curves.Length - 1) / Math.Abs(kernel.WaveV));

    /// <summary>Mean absolute difference between samples and the field fitted without their grid line; NaN if both directions have fewer
    /// than three lines. These fits keep the kernel, but move breaks and reselect the terms of polynomials without breaks.</summary>
    public double LeaveLineOutMm => _model.LineOut;

    /// <summary>Measured error minus field at each sample, in the given order.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Root of the sum of squared residuals per remaining degree of freedom (samples minus <see cref="Freedom"/>).</summary>
    public double ResidualStandardDeviationMm { get; }

    /// <summary>Degrees of freedom used by the fit: the terms of a polynomial, otherwise the trace of the smoothing matrix.</summary>
    public double Freedom => _model.Freedom;

    /// <summary>Standard deviation of the noise of one sample, as the model estimates it.</summary>
    public double NoiseMm => _model.Noise;

    /// <inheritdoc/>
    public override double At(double u, double v) => Combine(u, v, isUncertainty: false);

    /// <summary>Standard uncertainty of <see cref="At"/> in millimeters. It combines the covariance of the fit with its noise or the
    /// probe's stated uncertainty, whichever is larger. It does not cover errors of the model itself.</summary>
    /// <param name="u">First parameter of the nominal surface.</param>
    /// <param name="v">Second parameter of the nominal surface.</param>
    public override double StandardUncertaintyAt(double u, double v) =>
        Combine(u, v, isUncertainty: true);

    /// <summary>Evaluates within the samples. Beyond them, mirrors about the edge (2 f(edge) - f(inside)), or sums these parts.</summary>
    private double Combine(double u, double v, bool isUncertainty)
    {
        var (a, b) = (_u.ToUnit(u), _v.ToUnit(v));
        var (edgeA, edgeB) = (Math.Clamp(a, -1, 1), Math.Clamp(b, -1, 1));
        var insideA = edgeA - Math.Clamp(a - edgeA, -_spaceU, _spaceU);
        var insideB = edgeB - Math.Clamp(b - edgeB, -_spaceV, _spaceV);
        return edgeA == insideA ? AlongV(edgeA) : Mirror(AlongV(edgeA), AlongV(insideA));

        double AlongV(double x) => edgeB == insideB ? Value(x, edgeB) : Mirror(Value(x, edgeB), Value(x, insideB));

        double Value(double x, double y) => isUncertainty ? Math.Sqrt(_model.VarianceAt(x, y, _noise)) : _model.At(x, y);

        double Mirror(double edge, double inside) => isUncertainty ? (2 * edge) + inside : (2 * edge) - inside;
    }
}

namespace ErrorMatching.Freeform;

/// <summary>A field fitted to measured errors, with all that tells how far it can be trusted. Lengths in millimetres.</summary>
/// <remarks>
/// Beyond the outermost samples the field goes on straight for one mean distance of the lines and then stays as it is; its uncertainty grows accordingly.
/// A break is found only along a grid line, with two lines at least on each side; one that runs obliquely is not found, and the field is then a spline or a process that rounds it off.
/// </remarks>
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
        ResidualStandardDeviationMm = Math.Sqrt(Residuals.Sum(r => r * r) / Math.Max(1, data.Count - Math.Min(data.Count - 1, model.Freedom)));
        BreaksU = [.. model.BreaksU.Select(u.FromUnit)];
        BreaksV = [.. model.BreaksV.Select(v.FromUnit)];
    }

    /// <summary>Which kind of function described the samples best.</summary>
    public FieldModelKind Kind => _model.Kind;

    /// <summary>Parameters u at which the second derivative of the field jumps, rising.</summary>
    public IReadOnlyList<double> BreaksU { get; }

    /// <summary>Parameters v at which the second derivative of the field jumps, rising.</summary>
    public IReadOnlyList<double> BreaksV { get; }

    /// <summary>Mean absolute difference of the samples of whole grid lines from the field fitted without their line (the kernel kept, breaks moved and the terms of a polynomial without breaks chosen anew); NaN if there are fewer than three lines in both directions.</summary>
    public double LeaveLineOutMm => _model.LineOut;

    /// <summary>Measured error less field of each sample, in the order given.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Root of the sum of squared residuals over the degrees of freedom that the fit leaves (samples less <see cref="Freedom"/>).</summary>
    public double ResidualStandardDeviationMm { get; }

    /// <summary>How many samples the fit uses up: the number of terms of a polynomial, the trace of the smoothing matrix otherwise.</summary>
    public double Freedom => _model.Freedom;

    /// <summary>Standard deviation of the noise of one sample, as the model estimates it: what it does not take for systematic.</summary>
    public double NoiseMm => _model.Noise;

    /// <inheritdoc/>
    public override double At(double u, double v) => Combine(u, v, _model.At, straight: true);

    /// <summary>Standard uncertainty of <see cref="At"/> in millimetres, from the covariance of the fit and the larger of its noise and the probe's stated uncertainty. That the model itself is wrong is not in it.</summary>
    /// <param name="u">First parameter of the nominal surface.</param>
    /// <param name="v">Second parameter of the nominal surface.</param>
    public override double StandardUncertaintyAt(double u, double v) => Combine(u, v, (a, b) => Math.Sqrt(_model.VarianceAt(a, b, _noise)), straight: false);

    /// <summary>A value within the samples; beyond them mirrored about the edge (2 f(edge) - f(inside)), or the sum of what that combines.</summary>
    private double Combine(double u, double v, Func<double, double, double> value, bool straight)
    {
        var (a, b) = (_u.ToUnit(u), _v.ToUnit(v));
        var (edgeA, edgeB) = (Math.Clamp(a, -1, 1), Math.Clamp(b, -1, 1));
        var insideA = edgeA - Math.Clamp(a - edgeA, -_spaceU, _spaceU);
        var insideB = edgeB - Math.Clamp(b - edgeB, -_spaceV, _spaceV);
        return Mirror(edgeA, insideA, x => Mirror(edgeB, insideB, y => value(x, y)));

        double Mirror(double edge, double inside, Func<double, double> along) =>
            edge == inside ? along(edge) : straight ? (2 * along(edge)) - along(inside) : (2 * along(edge)) + along(inside);
    }
}

namespace ErrorMatching.Freeform;

/// <summary>The systematic error of a surface on its net, in millimeters: as measured, and as expected after either compensation.</summary>
/// <param name="Net">The places.</param>
/// <param name="BeforeMm">The systematic field, positive out of the material.</param>
/// <param name="MirrorMm">The remaining error after mirroring.</param>
/// <param name="ToolRadiusMm">The remaining error after modifying the tool radius.</param>
public sealed record ErrorMap(
    SurfaceNet Net, IReadOnlyList<double> BeforeMm, IReadOnlyList<double> MirrorMm, IReadOnlyList<double> ToolRadiusMm)
{
    /// <summary>The map of a compensation.</summary>
    public static ErrorMap Of(CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var gain = result.Input.Job.Compensation.Gain;
        (double U, double V)[] places = [.. SurfaceNet.Parameters(result.Input.Surface)];
        double[] before = [.. places.Select(p => result.Systematic.At(p.U, p.V))];

        // A surface through points leaves its own distance. A compensated field leaves its uncompensated share.
        double[] mirror = result.ThroughPoints is null
            ? Array.ConvertAll(before, e => e - (gain * e))
            : [.. before.Zip(places, (e, p) => e + result.MovedMmAt(p.U, p.V))];
        return new(SurfaceNet.Of(result.Input.Surface), before, mirror, Array.ConvertAll(before, e => e - (gain * result.Mean.At(0, 0))));
    }
}

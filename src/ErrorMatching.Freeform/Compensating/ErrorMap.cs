namespace ErrorMatching.Freeform;

/// <summary>The systematic error of a surface at the places of its net, in millimetres: as it is, and as either way of compensating is expected to leave it.</summary>
/// <param name="Net">The places.</param>
/// <param name="BeforeMm">The field that is taken as systematic, positive out of the material.</param>
/// <param name="MirrorMm">What mirroring leaves of it.</param>
/// <param name="ToolRadiusMm">What a modified tool radius leaves of it.</param>
public sealed record ErrorMap(SurfaceNet Net, IReadOnlyList<double> BeforeMm, IReadOnlyList<double> MirrorMm, IReadOnlyList<double> ToolRadiusMm)
{
    /// <summary>The map of a compensation.</summary>
    public static ErrorMap Of(CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var gain = result.Input.Job.Compensation.Gain;
        (double U, double V)[] places = [.. SurfaceNet.Parameters(result.Input.Surface)];
        double[] before = [.. places.Select(p => result.Systematic.At(p.U, p.V))];

        // A surface through points leaves what it leaves; a field that was compensated, its share.
        double[] mirror = result.ThroughPoints is null ? Array.ConvertAll(before, e => e - (gain * e)) : [.. before.Zip(places, (e, p) => e + result.MovedMmAt(p.U, p.V))];
        return new(SurfaceNet.Of(result.Input.Surface), before, mirror, Array.ConvertAll(before, e => e - (gain * result.Mean.At(0, 0))));
    }
}

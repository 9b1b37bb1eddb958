using System.Globalization;
using ErrorMatching.Measurement;

namespace ErrorMatching.Mating;

/// <summary>Whether the measured origin lies where it is designed (Wang 2021, section 2.2:
/// the origin is checked before any key point is measured).</summary>
/// <param name="Point">Label of the origin.</param>
/// <param name="DistanceMm">How far it is off.</param>
/// <param name="LimitMm">How far it may be off.</param>
public sealed record OriginCheck(string Point, double DistanceMm, double LimitMm)
{
    /// <summary>Code of the refusal of an origin that is off.</summary>
    public const string OriginOff = "origin-off";

    /// <summary>True if the origin is within its limit.</summary>
    public bool Holds => DistanceMm <= LimitMm;

    /// <summary>The refusal, or null if the check holds.</summary>
    public MatingRefusal? Refusal => Holds
        ? null
        : new(
            OriginOff,
            string.Create(
                CultureInfo.InvariantCulture,
                $"The origin {Point} was measured {DistanceMm:0.000} mm off, more than the {LimitMm:0.###} mm allowed: check clamping "
                    + $"and work offset, then measure again."),
            Point: Point);

    /// <summary>Checks the origin as measured, before any alignment.</summary>
    /// <param name="check">What the job asks for.</param>
    /// <param name="theoretical">Where the origin is designed.</param>
    /// <param name="measured">Where it was measured.</param>
    public static OriginCheck Of(JobOriginCheck check, LabelledPoint theoretical, LabelledPoint measured)
    {
        ArgumentNullException.ThrowIfNull(check);

        // A height that one of the files does not have is not a difference of 0 less the other's.
        var off = measured.Position - theoretical.Position;
        return new(check.Point, (measured.HasZ && theoretical.HasZ ? off : off with { Z = 0 }).Length, check.LimitMm);
    }

    /// <summary>The refusal of the first measurement whose origin is off, or null; without a check in the job, null.</summary>
    internal static MatingRefusal? Refuse(MatingJob job, MeasurementFile theoretical, params ReadOnlySpan<MeasurementFile?> measurements)
    {
        foreach (var file in measurements)
        {
            if (job.OriginCheck is { } check
                && file is not null
                && Of(check, theoretical[check.Point], file[check.Point]).Refusal is { } refusal)
            {
                return refusal with { Message = $"{file.File}: {refusal.Message}" };
            }
        }

        return null;
    }
}

using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Whether the measured origin is where it was designed (Wang 2021, section 2.2: check the origin before measuring any key
/// point).</summary>
/// <param name="Point">Label of the origin.</param>
/// <param name="DistanceMm">Distance from its designed position.</param>
/// <param name="LimitMm">Largest distance allowed.</param>
public sealed record OriginCheck(string Point, double DistanceMm, double LimitMm)
{
    /// <summary>Code of the refusal of an origin that is off.</summary>
    public const string OriginOff = "origin-off";

    /// <summary>True if the origin is within its limit.</summary>
    public bool Holds => DistanceMm <= LimitMm;

    /// <summary>The refusal, or null if the origin is within its limit.</summary>
    public Refusal? Refusal => Holds
        ? null
        : new(
            OriginOff,
            string.Create(
                CultureInfo.InvariantCulture,
                $"The origin {Point} was measured {DistanceMm:0.000} mm off, more than the {LimitMm:0.###} mm allowed: check clamping "
                    + $"and work offset, then measure again."),
            new() { Point = Point });

    /// <summary>Checks the origin as measured, before any alignment.</summary>
    /// <param name="check">The check that the job requests.</param>
    /// <param name="theoretical">The origin as designed.</param>
    /// <param name="measured">The origin as measured.</param>
    public static OriginCheck Check(JobOriginCheck check, LabelledPoint theoretical, LabelledPoint measured)
    {
        ArgumentNullException.ThrowIfNull(check);

        // Compare heights only if both files have them: a missing one is not 0.
        var off = measured.Position - theoretical.Position;
        return new(check.Point, (measured.HasZ && theoretical.HasZ ? off : off with { Z = 0 }).Length, check.LimitMm);
    }

    /// <summary>The refusal of the first measurement with an origin outside its limit, or null; null also if no check is
    /// wanted.</summary>
    internal static Refusal? Refuse(
        JobOriginCheck? wanted, MeasurementFile theoretical, params ReadOnlySpan<MeasurementFile?> measurements)
    {
        foreach (var file in measurements)
        {
            if (wanted is { } check
                && file is not null
                && Check(check, theoretical[check.Point], file[check.Point]).Refusal is { } refusal)
            {
                return refusal with { Message = $"{file.File}: {refusal.Message}" };
            }
        }

        return null;
    }
}

/// <summary>A point whose measured position must match its design before anything is compared (Wang 2021, section 2.2).</summary>
/// <param name="Point">Label of the point in the theoretical and the measured file.</param>
/// <param name="LimitMm">The largest distance allowed.</param>
public sealed record JobOriginCheck(string Point, double LimitMm);

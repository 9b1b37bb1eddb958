using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Converts measured points to errors along the normal.</summary>
internal static class SurfaceErrors
{
    /// <summary>Returns the error at each measured point: its signed distance from the nominal surface along the normal, minus the stock
    /// of the stage.</summary>
    /// <param name="surface">The nominal surface.</param>
    /// <param name="points">Points of the measuring plan with their measured contacts, in millimeters.</param>
    /// <param name="stockMm">Expected stock on the surface.</param>
    /// <param name="file">Name of the file of measured points, for messages.</param>
    /// <exception cref="InputException"><c>no-foot</c>: a point is too far away for any normal of the surface.</exception>
    public static IReadOnlyList<ErrorSample> Find(
        PartSurface surface, IEnumerable<(PlanPoint Plan, Point3 Contact)> points, double stockMm, string file)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(points);
        var samples = new List<ErrorSample>();
        foreach (var (plan, contact) in points)
        {
            if (NormalFoot.Find(surface.Spline, contact, plan.U, plan.V) is not { } foot)
            {
                throw InputException.At("no-foot", file, string.Create(
                    CultureInfo.InvariantCulture,
                    $"point {plan.Number} was measured at {PlaceText.Words(contact, 4)}, where no normal of the surface leads; near "
                        + $"{PlaceText.Words(plan.Position, 4)} is expected"));
            }

            var normal = surface.NormalOf(foot);
            samples.Add(new(
                plan.Number, plan.I, plan.J, foot.U, foot.V, foot.Position, normal, (contact - foot.Position).Dot(normal) - stockMm));
        }

        return samples;
    }
}

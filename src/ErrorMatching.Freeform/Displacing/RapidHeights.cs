using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>Finds rapid moves through what may lie over a surface before it is finished.</summary>
/// <remarks>A rapid move is taken for a straight line. It may begin where the ball touches, and leave straight up, or so that the gap
/// grows.</remarks>
/// <param name="walk">The surface under the ball.</param>
/// <param name="material">What may lie over it, and by how much the program is moved.</param>
internal sealed class RapidHeights(SurfaceWalk walk, StageMaterial material)
{
    // The gap is looked at in steps so short that between two of them it changes by less than what passes for touching.
    private const double StepMm = SurfaceDisplacer.TouchMm;

    // Of a rapid move that is long beyond reason and skims the material, so many that nothing hangs.
    private const int MostSteps = 1000;

    // A slanted move leaves what it touched if its gap grows by this share of its way.
    private const double Leaves = 0.05;

    // Chordal error and rounding of the program.
    private const double RoundingMm = 0.01;

    /// <summary>Returns the first place at which a move is too low, with the gap between ball and nominal surface there; null if there is
    /// none.</summary>
    /// <param name="motion">A move whose end is known.</param>
    /// <param name="start">The contact where it starts; null if that is not known.</param>
    /// <param name="end">The contact at its end.</param>
    public (Point3 Place, double OverMm)? FirstTooLow(in NcMotion motion, SurfaceContact? start, SurfaceContact end)
    {
        if (start is { } from && motion.UnknownStart == AxisSet.None)
        {
            var way = motion.End - motion.Start;
            var length = way.Length;
            var leaves = way is { X: 0, Y: 0, Z: >= 0 } ? 0 : Leaves;
            for (double at = 0, step = 0; at < length; at += step)
            {
                var place = motion.Start + (way * (at / length));
                var overMm = walk.At(place).OverMm;
                if (IsTooLow(place, overMm, from.OverMm + (leaves * at)))
                {
                    return (place, overMm);
                }

                // The gap cannot close faster than the ball travels.
                step = Math.Max(Math.Max(StepMm, length / MostSteps), overMm - material.Mm);
            }

            return IsTooLow(motion.End, end.OverMm, from.OverMm + (leaves * length)) ? (motion.End, end.OverMm) : null;
        }

        return IsTooLow(motion.End, end.OverMm, material.Mm) ? (motion.End, end.OverMm) : null;
    }

    private bool IsTooLow(Point3 place, double overMm, double leavingMm) =>
        overMm < Math.Min(material.Mm, leavingMm) - RoundingMm && walk.IsOverPart(place);
}

using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Identifies equal motions regardless of their position in a program: kind, plane, end and center on a grid so fine that only
/// equal decimals coincide.</summary>
internal readonly record struct MotionPlace(
    MotionKind Kind, CoordinatePlane Plane, int Turns, long X, long Y, long Z, long CenterX, long CenterY)
{
    private const double StepsPerMm = 1e7;

    /// <summary>The place of a motion.</summary>
    public static MotionPlace Of(in NcMotion m) => m.IsArc
        ? new(m.Kind, m.Plane, m.Turns, Step(m.End.X), Step(m.End.Y), Step(m.End.Z), Step(m.Center.X), Step(m.Center.Y))
        : new(m.Kind, m.Plane, 0, Step(m.End.X), Step(m.End.Y), Step(m.End.Z), 0, 0);

    /// <summary>A number for each motion, equal for equal places.</summary>
    public static int[] Numbers(NcPath path, Dictionary<MotionPlace, int> known)
    {
        var numbers = new int[path.Motions.Length];
        for (var i = 0; i < numbers.Length; i++)
        {
            var place = Of(path.Motions[i]);
            if (!known.TryGetValue(place, out numbers[i]))
            {
                numbers[i] = known.Count;
                known.Add(place, numbers[i]);
            }
        }

        return numbers;
    }

    // A coordinate beyond the range of a long saturates: no machine has such a place.
    private static long Step(double millimeters) => (long)Math.Round(millimeters * StepsPerMm);
}

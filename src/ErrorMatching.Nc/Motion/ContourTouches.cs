using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Where the cuts of a contour touch earlier ones. A contour that returns to a place closes there only if it has not touched
/// itself in between: a raster that passes through the corner of its first line, hundreds of lines later, does not close it.</summary>
internal sealed class ContourTouches
{
    /// <summary>Contours of more motions are not searched; a place to which they return is taken for their closing.</summary>
    public const int MostMotions = 50_000;

    // Cuts that come this near touch, mm; arcs are taken as chords that leave them by less than ChordMm.
    private const double NearMm = 1e-4;
    private const double ChordMm = 0.01;

    // Cells that all chords together may pass. Long lines in a fine grid would cost more.
    private const double MostCells = 2e7;

    private readonly int _first;

    // For each motion, the first later one that touches it or a motion after it.
    private readonly int[] _touched;

    private ContourTouches(int first, int[] touched) => (_first, _touched) = (first, touched);

    /// <summary>Searches some motions of a contour.</summary>
    /// <param name="motions">The path.</param>
    /// <param name="first">First motion.</param>
    /// <param name="last">Last motion.</param>
    /// <returns>The touches; null if they are too many to search.</returns>
    public static ContourTouches? Of(NcMotions motions, int first, int last)
    {
        if (last - first >= MostMotions)
        {
            return null;
        }

        var touched = new int[last - first + 1];
        Array.Fill(touched, int.MaxValue);
        var chords = new List<(int Motion, int Order, Segment2 Line)>();
        var order = 0;
        for (var i = first; i <= last; i++)
        {
            if (motions[i] is { IsCut: true, MovesInPlane: true } motion)
            {
                AddChords(chords, i, order++, motion);
            }
        }

        if (chords.Count > 0 && !Search(chords, touched, first))
        {
            return null;
        }

        for (var i = touched.Length - 2; i >= 0; i--)
        {
            touched[i] = Math.Min(touched[i], touched[i + 1]);
        }

        return new(first, touched);
    }

    /// <summary>True if the cuts from one motion to another do not touch, other than where one continues the next.</summary>
    public bool IsSimple(int first, int last) => _touched[first - _first] > last;

    private static void AddChords(List<(int, int, Segment2)> chords, int index, int order, in NcMotion motion)
    {
        var count = 1;
        if (motion.IsArc && motion.Arc.Radius > ChordMm)
        {
            var step = 2 * Elementary.Acos(1 - (ChordMm / motion.Arc.Radius));
            count = (int)Math.Clamp(Math.Ceiling(Math.Abs(motion.Arc.Sweep.Radians) / step), 1, 10_000);
        }

        var from = motion.PlaneStart;
        for (var k = 1; k <= count; k++)
        {
            var to = k == count ? motion.PlaneEnd : motion.PlaneAt((double)k / count);
            chords.Add((index, order, new(from, to)));
            from = to;
        }
    }

    // False if the chords pass too many cells.
    private static bool Search(List<(int Motion, int Order, Segment2 Line)> chords, int[] touched, int first)
    {
        var ends = chords.ConvertAll(c => c.Line.End);
        ends.Add(chords[0].Line.Start);
        var (minX, maxX, minY, maxY) = (ends.Min(p => p.X), ends.Max(p => p.X), ends.Min(p => p.Y), ends.Max(p => p.Y));
        var size = Math.Max(Math.Sqrt((maxX - minX) * (maxY - minY) / chords.Count), Math.Max(maxX - minX, maxY - minY) / chords.Count);
        size = Math.Max(size, 10 * NearMm);
        if (chords.Sum(c => (c.Line.Length / size) + 2) > MostCells)
        {
            return false;
        }

        var cells = new Dictionary<(int, int), List<int>>();
        for (var k = 0; k < chords.Count; k++)
        {
            foreach (var cell in CellsOf(chords[k].Line, minX, minY, size))
            {
                if (!cells.TryGetValue(cell, out var inside))
                {
                    cells.Add(cell, inside = []);
                }

                // The chords come in path order: the first that touches is the first of all.
                inside.RemoveAll(other => touched[chords[other].Motion - first] != int.MaxValue);
                foreach (var other in inside)
                {
                    if (chords[k].Order > chords[other].Order + 1 && Touch(chords[k].Line, chords[other].Line))
                    {
                        touched[chords[other].Motion - first] = chords[k].Motion;
                    }
                }

                inside.Add(k);
            }
        }

        return true;
    }

    // The cells within reach of a chord, row by row.
    private static IEnumerable<(int, int)> CellsOf(Segment2 line, double minX, double minY, double size)
    {
        var (low, high) = line.Start.Y <= line.End.Y ? (line.Start, line.End) : (line.End, line.Start);
        var (bottom, top) = (Cell(low.Y - NearMm - minY, size), Cell(high.Y + NearMm - minY, size));
        var slope = high.Y - low.Y > NearMm ? (high.X - low.X) / (high.Y - low.Y) : 0;
        for (var row = bottom; row <= top; row++)
        {
            var (from, to) = (low.X, high.X);
            if (slope != 0 || high.Y - low.Y > NearMm)
            {
                var y0 = Math.Clamp(minY + (row * size) - NearMm, low.Y, high.Y);
                var y1 = Math.Clamp(minY + ((row + 1) * size) + NearMm, low.Y, high.Y);
                (from, to) = (low.X + ((y0 - low.Y) * slope), low.X + ((y1 - low.Y) * slope));
            }

            var (left, right) = (Cell(Math.Min(from, to) - NearMm - minX, size), Cell(Math.Max(from, to) + NearMm - minX, size));
            for (var column = left; column <= right; column++)
            {
                yield return (column, row);
            }
        }
    }

    private static int Cell(double offset, double size) => (int)Math.Floor(offset / size);

    private static bool Touch(Segment2 a, Segment2 b)
    {
        var (along, other) = (a.End - a.Start, b.End - b.Start);
        var crosses = Side(along, b.Start - a.Start) * Side(along, b.End - a.Start) < 0
            && Side(other, a.Start - b.Start) * Side(other, a.End - b.Start) < 0;
        return crosses || IsNear(a, b.Start) || IsNear(a, b.End) || IsNear(b, a.Start) || IsNear(b, a.End);
    }

    private static double Side(Vector2 along, Vector2 to) => Math.Sign(along.Cross(to));

    private static bool IsNear(Segment2 line, Point2 point)
    {
        var along = line.End - line.Start;
        var square = along.Dot(along);
        var fraction = square > 0 ? Math.Clamp((point - line.Start).Dot(along) / square, 0, 1) : 0;
        return (line.Start + (fraction * along)).DistanceTo(point) <= NearMm;
    }
}

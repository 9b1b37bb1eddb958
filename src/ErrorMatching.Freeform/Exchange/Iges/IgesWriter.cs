using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Writes a surface as an IGES file (version 5.3, fixed form, millimeters): entity 128, inside 144 if trimmed.</summary>
/// <remarks>The same surface gives the same bytes, because the dates in the file are constant. Numbers round-trip exactly.</remarks>
public static class IgesWriter
{
    /// <summary>Returns the file's bytes.</summary>
    /// <param name="surface">The surface with its boundaries, in millimeters.</param>
    public static byte[] Write(PartSurface surface)
    {
        ArgumentNullException.ThrowIfNull(surface);
        var file = new IgesRecords(surface.Name);
        if (surface.Region.IsWhole)
        {
            Spline(file, surface.Spline, dependent: false, surface.Name);
            return file.ToBytes(Largest(surface.Spline));
        }

        var (spline, loops) = (surface.Spline, surface.Region.Loops);
        var trimmed = file.Reserve();
        var basis = Spline(file, spline, dependent: true, "");
        var boundaries = loops.Select(l => Boundary(file, basis, l)).ToList();

        // Loops do not state whether they are outer boundaries or holes; readers count crossings. So the largest comes first.
        var first = Enumerable.Range(0, loops.Count).MaxBy(i => Math.Abs(RegionLoop.Area(loops[i])));
        file.Fill(
            trimmed,
            144,
            0,
            dependent: false,
            surface.Name,
            [basis, 1, loops.Count - 1, boundaries[first], .. boundaries.Where((_, i) => i != first).Select(b => (IgesValue)b)]);
        return file.ToBytes(Largest(spline));
    }

    private static int Spline(IgesRecords file, SplineSurface s, bool dependent, string name)
    {
        var (u, v) = (s.KnotsU, s.KnotsV);
        List<IgesValue> values = [s.CountU - 1, s.CountV - 1, u.Degree, v.Degree, 0, 0, s.IsRational ? 0 : 1, 0, 0];
        values.AddRange(u.Values.ToArray().Select(k => (IgesValue)k));
        values.AddRange(v.Values.ToArray().Select(k => (IgesValue)k));
        for (var j = 0; j < s.CountV; j++)
        {
            for (var i = 0; i < s.CountU; i++)
            {
                values.Add(s.IsRational ? s.Weights[(i * s.CountV) + j] : 1.0);
            }
        }

        for (var j = 0; j < s.CountV; j++)
        {
            for (var i = 0; i < s.CountU; i++)
            {
                var pole = s.Poles[(i * s.CountV) + j];
                values.AddRange([pole.X, pole.Y, pole.Z]);
            }
        }

        values.AddRange([u.Start, u.End, v.Start, v.End]);
        var at = file.Reserve();
        file.Fill(at, 128, 0, dependent, name, values);
        return at;
    }

    // A polygon of (u, v) as a B-spline of degree 1. Readers that need it in space map it onto the surface.
    private static int Boundary(IgesRecords file, int basis, IReadOnlyList<Point2> loop)
    {
        List<Point2> closed = [.. loop, loop[0]];
        var values = new List<IgesValue> { closed.Count - 1, 1, 1, 1, 1, 0 };
        values.Add(0.0);
        values.AddRange(Enumerable.Range(0, closed.Count).Select(i => (IgesValue)(double)i));
        values.Add((double)(closed.Count - 1));
        values.AddRange(closed.Select(_ => (IgesValue)1.0));
        foreach (var p in closed)
        {
            values.AddRange([p.X, p.Y, 0.0]);
        }

        values.AddRange([0.0, (double)(closed.Count - 1), 0.0, 0.0, 1.0]);
        var curve = file.Reserve();
        file.Fill(curve, 126, 0, dependent: true, "", values);
        var boundary = file.Reserve();
        file.Fill(boundary, 142, 0, dependent: true, "", [0, basis, curve, 0, 1]);
        return boundary;
    }

    private static double Largest(SplineSurface surface)
    {
        var largest = 0.0;
        foreach (var p in surface.Poles)
        {
            largest = Math.Max(largest, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
        }

        return largest;
    }
}

namespace ErrorMatching.Geometry;

/// <summary>Checks and converts poles and weights of curves and surfaces.</summary>
internal static class SplinePoles
{
    public static void Check(int expected, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights)
    {
        if (poles.Length != expected)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{poles.Length} poles; the knots need {expected}");
        }

        if (weights.Length != 0 && weights.Length != expected)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{weights.Length} weights; the poles need {expected}, or none");
        }

        for (var i = 0; i < poles.Length; i++)
        {
            if (!poles[i].IsFinite)
            {
                throw new GeometryException(GeometryError.NotFinite, $"pole {i + 1} has a coordinate that is no finite number");
            }
        }

        for (var i = 0; i < weights.Length; i++)
        {
            if (!double.IsFinite(weights[i]) || weights[i] <= 0)
            {
                throw new GeometryException(GeometryError.BadPoles, $"weight {i + 1} is not a positive finite number");
            }
        }
    }

    /// <summary>The weights; null if they are all equal and therefore redundant.</summary>
    public static double[]? Weights(ReadOnlySpan<double> weights) =>
        weights.Length == 0 || weights.IndexOfAnyExcept(weights[0]) < 0 ? null : weights.ToArray();

    /// <summary>Poles as rows of x, y, z, or of wx, wy, wz, w if there are weights.</summary>
    public static double[] Flatten(ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights)
    {
        var size = weights.Length == 0 ? 3 : 4;
        var values = new double[poles.Length * size];
        for (var i = 0; i < poles.Length; i++)
        {
            var w = size == 3 ? 1 : weights[i];
            var row = values.AsSpan(i * size, size);
            (row[0], row[1], row[2]) = (poles[i].X * w, poles[i].Y * w, poles[i].Z * w);
            if (size == 4)
            {
                row[3] = w;
            }
        }

        return values;
    }

    /// <summary>Poles and weights from rows in the format of <see cref="Flatten"/>.</summary>
    public static (Point3[] Poles, double[] Weights) Unflatten(ReadOnlySpan<double> values, bool rational)
    {
        var size = rational ? 4 : 3;
        var poles = new Point3[values.Length / size];
        var weights = new double[rational ? poles.Length : 0];
        for (var i = 0; i < poles.Length; i++)
        {
            var row = values.Slice(i * size, size);
            var w = rational ? row[3] : 1;
            poles[i] = rational ? new(row[0] / w, row[1] / w, row[2] / w) : new(row[0], row[1], row[2]);
            if (rational)
            {
                weights[i] = w;
            }
        }

        return (poles, weights);
    }

    /// <summary>A bound of the distance between two splines over the same knots, from their poles in the format of <see cref="Flatten"/>:
    /// a spline is inside the hull of its poles. For rational splines, the difference of A / w and B / h is ((A - B) - (B / h) (w - h)) /
    /// w, relative to the middle of the poles.</summary>
    public static double Moved(ReadOnlySpan<double> before, ReadOnlySpan<double> after, bool rational)
    {
        var size = rational ? 4 : 3;
        var box = Box3.Around(Unflatten(before, rational).Poles);
        var middle = box.Min + ((box.Max - box.Min) * 0.5);
        var (points, weights, reach, least) = (0.0, 0.0, 0.0, double.PositiveInfinity);
        for (var i = 0; i < before.Length; i += size)
        {
            var (w, h) = rational ? (before[i + 3], after[i + 3]) : (1.0, 1.0);
            var seen = new Vector3(after[i] - (h * middle.X), after[i + 1] - (h * middle.Y), after[i + 2] - (h * middle.Z));
            var difference = new Vector3(before[i] - (w * middle.X), before[i + 1] - (w * middle.Y), before[i + 2] - (w * middle.Z)) - seen;
            points = Math.Max(points, difference.Length);
            weights = Math.Max(weights, Math.Abs(w - h));
            reach = Math.Max(reach, seen.Length / h);
            least = Math.Min(least, w);
        }

        return (points + (reach * weights)) / least;
    }
}

using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>An affine map of the file's coordinates: rotation, reflection or scaling, then a translation (entity 124).</summary>
/// <param name="X">Coefficients of the first coordinate of the result.</param>
/// <param name="Y">Coefficients of the second.</param>
/// <param name="Z">Coefficients of the third.</param>
/// <param name="Shift">The translation.</param>
internal sealed record IgesTransform(Vector3 X, Vector3 Y, Vector3 Z, Vector3 Shift)
{
    public static IgesTransform Identity { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), Vector3.Zero);

    /// <summary>Returns the map of an entity's directory entry, combined with the maps that it refers to.</summary>
    /// <exception cref="InputException">A matrix is broken, or the references are circular.</exception>
    public static IgesTransform Of(IgesFile file, IgesEntity entity)
    {
        var result = Identity;
        for (var (at, depth) = (entity, 0); at.Transform != 0; depth++)
        {
            var matrix = file.At(at.Transform, at, "its transformation matrix");
            if (matrix.Type != 124)
            {
                throw file.Fail("bad-pointer", $"{at} has {matrix} for its transformation matrix; entity 124 is expected", at.Line);
            }

            if (depth == ExchangeLimits.MaxDepth)
            {
                throw file.Fail(
                    "too-deep", $"the transformation matrices of {entity} refer to one another more than {depth} times", entity.Line);
            }

            result = Read(file.ParametersOf(matrix)).After(result);
            at = matrix;
        }

        return result;
    }

    /// <summary>Returns the map that applies another one first.</summary>
    public IgesTransform After(IgesTransform first)
    {
        Vector3 Row(Vector3 r) => new(
            (r.X * first.X.X) + (r.Y * first.Y.X) + (r.Z * first.Z.X),
            (r.X * first.X.Y) + (r.Y * first.Y.Y) + (r.Z * first.Z.Y),
            (r.X * first.X.Z) + (r.Y * first.Y.Z) + (r.Z * first.Z.Z));
        return ReferenceEquals(first, Identity) ? this : ReferenceEquals(this, Identity) ? first
            : new(Row(X), Row(Y), Row(Z), new(X.Dot(first.Shift) + Shift.X, Y.Dot(first.Shift) + Shift.Y, Z.Dot(first.Shift) + Shift.Z));
    }

    /// <summary>Maps a point.</summary>
    /// <param name="p">The point.</param>
    /// <param name="scale">Factor applied to the result: millimeters per unit.</param>
    public Point3 Map(Vector3 p, double scale) => ReferenceEquals(this, Identity)
        ? new(p.X * scale, p.Y * scale, p.Z * scale)
        : new((X.Dot(p) + Shift.X) * scale, (Y.Dot(p) + Shift.Y) * scale, (Z.Dot(p) + Shift.Z) * scale);

    private static IgesTransform Read(IgesParameters parameters)
    {
        var r = parameters.Reals("the matrix", 12);
        var map = new IgesTransform(new(r[0], r[1], r[2]), new(r[4], r[5], r[6]), new(r[8], r[9], r[10]), new(r[3], r[7], r[11]));
        return Math.Abs(map.X.Cross(map.Y).Dot(map.Z)) > 1e-12
            ? map
            : throw parameters.Fail("bad-matrix", "a transformation that flattens space; a rotation is expected");
    }
}

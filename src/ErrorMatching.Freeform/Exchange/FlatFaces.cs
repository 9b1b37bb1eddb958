using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The flat faces of a STEP file (ISO 10303-21: AP203, AP214, AP242), such as the top and the bottom of a plate.</summary>
public sealed class FlatFaces
{
    /// <summary>Maximum file size in bytes.</summary>
    public const int MaxBytes = ExchangeLimits.MaxBytes;

    private readonly Lazy<StepWalls> _walls;

    private FlatFaces(IReadOnlyList<FlatFace> faces, IReadOnlyDictionary<string, int> others, double unitMm, Lazy<StepWalls> walls) =>
        (Faces, Others, UnitMm, _walls) = (faces, others, unitMm, walls);

    /// <summary>The faces on planes (PLANE), in file order.</summary>
    public IReadOnlyList<FlatFace> Faces { get; }

    /// <summary>How many faces are on other surfaces, by the name of the surface in STEP.</summary>
    public IReadOnlyDictionary<string, int> Others { get; }

    /// <summary>Millimeters in the unit of the file's lengths; 1 if it has no flat face.</summary>
    public double UnitMm { get; }

    /// <summary>The dimensions and tolerances of the file, as they are meant (semantic PMI), in file order. What is wrong in one, it says
    /// itself.</summary>
    public IReadOnlyList<ModelAnnotation> Annotations { get; private init; } = [];

    /// <summary>The standard of the tolerances.</summary>
    public ToleranceStandard Standard { get; private init; }

    /// <summary>The faces that meet at an edge of a face, flat or not.</summary>
    /// <param name="edge"><see cref="FaceEdge.Number"/>.</param>
    public IReadOnlyList<WallFace> FacesAt(long edge) => _walls.Value.At(edge);

    /// <summary>True if a file begins as STEP files do.</summary>
    /// <param name="bytes">Its content.</param>
    public static bool IsStep(ReadOnlySpan<byte> bytes)
    {
        var start = Encoding.Latin1.GetString(bytes[..Math.Min(bytes.Length, 4096)]);
        return start.AsSpan(StepLexer.SkipBlanks(start, 0)).StartsWith("ISO-10303-21");
    }

    /// <summary>Finds the flat faces of a file.</summary>
    /// <param name="bytes">Its content.</param>
    /// <param name="file">Its name, for messages.</param>
    /// <param name="unitMm">Millimeters per unit, whatever the file says; null to take what it says.</param>
    /// <exception cref="InputException">It is no STEP file, is broken or too large, says no unit, or an assembly moves its
    /// parts.</exception>
    public static FlatFaces Read(ReadOnlySpan<byte> bytes, string file, double? unitMm = null)
    {
        if (bytes.Length > MaxBytes)
        {
            throw InputException.At(
                "too-large", file, $"{bytes.Length} bytes; at most {MaxBytes} are read. Export the one part alone");
        }

        var step = new StepFile(bytes, file);
        StepAssembly.ThrowIfMoved(step);
        var (faces, others, unit) = (new List<FlatFace>(), new SortedDictionary<string, int>(StringComparer.Ordinal), 1.0);
        var items = StepItems.Of(step, unitMm);
        foreach (var item in items)
        {
            if (!StepFace.IsFace(item.Instance))
            {
                continue;
            }

            var surface = item.Instance.Records[0].Instance(2);
            if (surface.Keyword == "PLANE")
            {
                unit = faces.Count == 0 ? item.MillimetersPerUnit : unit;
                faces.Add(new(item, surface.Records[0]));
            }
            else
            {
                var kind = surface.Records.Count == 1 ? surface.Keyword : "B_SPLINE_SURFACE";
                others[kind] = others.GetValueOrDefault(kind) + 1;
            }
        }

        return new(faces, others, unit, new(() => new(items)))
        {
            Annotations = StepAnnotations.Of(step, Corrected(step, unitMm)),
            Standard = StepAnnotations.StandardOf(step),
        };
    }

    // A unit that the user corrects is corrected for the tolerances in it, too.
    private static Func<double, double> Corrected(StepFile step, double? unitMm)
    {
        double? stated = unitMm is null ? null : StepItems.StatedUnit(step);
        return mm => unitMm is { } right && stated is { } wrong && Math.Abs(mm - wrong) <= 1e-9 * wrong ? right : mm;
    }
}

/// <summary>A face on a plane. Its edges are read when they are asked for, so that what is wrong in a face that nobody wants does not
/// matter.</summary>
public sealed class FlatFace
{
    private readonly StepItem _item;

    internal FlatFace(StepItem item, StepRecord plane)
    {
        var frame = StepPlacement.Of(plane.Instance(1));
        var origin = frame.Origin * item.MillimetersPerUnit;
        (_item, Origin, Normal) = (item, new(origin.X, origin.Y, origin.Z), frame.Z);
    }

    /// <summary>The number of its instance: 45 for <c>#45=ADVANCED_FACE(...)</c>.</summary>
    public long Number => _item.Instance.Id;

    /// <summary>The line in the file on which it begins.</summary>
    public int Line => _item.Instance.Line;

    /// <summary>Its name; empty if it has none.</summary>
    public string Name => _item.Instance.Name;

    /// <summary>A point of its plane, mm.</summary>
    public Point3 Origin { get; }

    /// <summary>The unit normal of its plane. It may point into the material.</summary>
    public Vector3 Normal { get; }

    /// <summary>Reads its bounds: outlines of the face and of the holes in it, each as edges that follow one another.</summary>
    /// <returns>The edges as the bounds pass them. Bounds that are a single point are left out.</returns>
    /// <exception cref="InputException">A bound or an edge is broken, of a kind that is not read, or not in the plane.</exception>
    public IReadOnlyList<IReadOnlyList<FaceEdge>> ReadBounds() => new StepBounds(_item, Origin, Normal).Read();

    /// <inheritdoc/>
    public override string ToString() => _item.Instance.ToString();
}

/// <summary>An edge of a face, as the bound of the face passes it.</summary>
/// <param name="Entity">What it is in the file: <c>#33 CIRCLE</c>.</param>
/// <param name="Line">The line in the file on which that begins.</param>
public abstract record FaceEdge(string Entity, int Line)
{
    /// <summary>The number of its EDGE_CURVE, which it shares with the face beside it; 0 if it has none.</summary>
    public long Number { get; init; }

    /// <summary>True if the bounds of the face pass it twice: the face is on both sides of it, so it limits nothing.</summary>
    public bool IsInside { get; init; }
}

/// <summary>A straight edge.</summary>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Line">The line in the file.</param>
/// <param name="From">Its start, mm.</param>
/// <param name="To">Its end, mm.</param>
public sealed record StraightEdge(string Entity, int Line, Point3 From, Point3 To) : FaceEdge(Entity, Line);

/// <summary>An edge on a circle or an ellipse: center + x cos t + y sin t.</summary>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Line">The line in the file.</param>
/// <param name="Center">The center, mm.</param>
/// <param name="X">From the center to t = 0, mm.</param>
/// <param name="Y">From the center to a quarter turn, mm; perpendicular to <paramref name="X"/>.</param>
/// <param name="Start">The t of its start, radians.</param>
/// <param name="Sweep">The change of t to its end, radians: negative if it turns from y to x, two pi if it is whole.</param>
public sealed record RoundEdge(string Entity, int Line, Point3 Center, Vector3 X, Vector3 Y, double Start, double Sweep)
    : FaceEdge(Entity, Line)
{
    /// <summary>True if it is on a circle.</summary>
    public bool IsCircular { get; init; }
}

/// <summary>An edge along a B-spline.</summary>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Line">The line in the file.</param>
/// <param name="Curve">The curve from the start of the edge to its end, mm.</param>
public sealed record SplineEdge(string Entity, int Line, SplineCurve Curve) : FaceEdge(Entity, Line);

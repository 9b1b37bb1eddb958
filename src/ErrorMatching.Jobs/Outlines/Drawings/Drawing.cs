using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The curves of a drawing in one plane, in millimeters.</summary>
/// <param name="File">The file, as given by the caller.</param>
/// <param name="Unit">The length that the drawing's numbers mean, and who says so.</param>
/// <param name="Curves">Its curves in the order of the file, those of blocks in their places.</param>
/// <param name="Notes">What was passed over or closed, in sentences.</param>
internal sealed record Drawing(string File, DrawingUnit Unit, IReadOnlyList<DrawnCurve> Curves, IReadOnlyList<string> Notes)
{
    /// <summary>The names of its layers with curves, in the order of the file.</summary>
    public IReadOnlyList<string> Layers => [.. Curves.Select(c => c.Layer).Distinct(StringComparer.Ordinal)];

    /// <summary>Where a layer is and what it is called, as the end of a sentence: <c> at Z 10 mm</c>. Layers of which nothing is known
    /// are missing.</summary>
    public IReadOnlyDictionary<string, string> Places { get; init; } = new Dictionary<string, string>();

    /// <summary>The dimensions and tolerances of a model; none of a drawing.</summary>
    public IReadOnlyList<ModelAnnotation> Annotations { get; init; } = [];

    /// <summary>The standard of the tolerances.</summary>
    public ToleranceStandard Standard { get; init; }

    /// <summary>Reads a drawing. A STEP file says itself that it is one; for others, the extension decides.</summary>
    /// <param name="file">The file.</param>
    /// <param name="unitMm">Millimeters in its unit, whatever it says itself; null if it says it.</param>
    /// <exception cref="InputException">It cannot be opened or read, or is of another kind.</exception>
    public static Drawing Read(string file, double? unitMm)
    {
        var extension = Path.GetExtension(file).ToUpperInvariant();
        if (extension is not (".DXF" or ".STP" or ".STEP"))
        {
            throw InputException.At(
                "not-a-drawing", file, $"\"{extension}\" is no drawing that is read; expected a .dxf, .stp or .step file.");
        }

        var bytes = InputFile.Bytes(file, Math.Max(DxfLimits.MaxBytes, FlatFaces.MaxBytes));
        return extension != ".DXF" || FlatFaces.IsStep(bytes)
            ? StepDrawing.Read(bytes, file, unitMm)
            : DxfReader.Read(bytes, file, unitMm);
    }
}

/// <summary>The length that the numbers of a drawing mean.</summary>
/// <param name="Mm">Millimeters per unit.</param>
/// <param name="IsStated">True if the file or the caller says so; false if millimeters are taken because nobody does.</param>
internal readonly record struct DrawingUnit(double Mm, bool IsStated);

/// <summary>A curve of a drawing, from its start to its end.</summary>
/// <param name="Layer">Its layer.</param>
/// <param name="Entity">What it is in the file, for messages: <c>LINE at line 120</c>.</param>
internal abstract record DrawnCurve(string Layer, string Entity)
{
    /// <summary>The numbers of the edges of a model that it is, where they have one.</summary>
    public IReadOnlyList<long> Edges { get; init; } = [];

    /// <summary>The faces of a model that meet the drawn one in it; none is known of a drawing.</summary>
    public IReadOnlyList<DrawnWall> Walls { get; init; } = [];

    /// <summary>Its start.</summary>
    public abstract Point2 From { get; }

    /// <summary>Its end.</summary>
    public abstract Point2 To { get; }

    /// <summary>Its length, mm.</summary>
    public abstract double LengthMm { get; }

    /// <summary>The place at a length from its start.</summary>
    public abstract Point2 AtLength(double mm);

    /// <summary>The unit vector in which it leaves its start.</summary>
    public abstract Vector2 DirectionAtStart { get; }

    /// <summary>The unit vector in which it arrives at its end.</summary>
    public Vector2 DirectionAtEnd => -Reversed().DirectionAtStart;

    /// <summary>The same curve from its end to its start.</summary>
    public abstract DrawnCurve Reversed();
}

/// <summary>A face of a model that meets the drawn face in a curve.</summary>
/// <param name="Face">The number of its instance.</param>
/// <param name="IsUpright">True if it is perpendicular to the drawing, so that its normal is that of the outline.</param>
/// <param name="Outward">The direction out of the material in the drawing, of any length; null if the file does not say it.</param>
internal sealed record DrawnWall(long Face, bool IsUpright, Vector2? Outward);

/// <summary>A line.</summary>
/// <param name="Layer">Its layer.</param>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Start">Its start.</param>
/// <param name="End">Its end.</param>
internal sealed record DrawnLine(string Layer, string Entity, Point2 Start, Point2 End) : DrawnCurve(Layer, Entity)
{
    /// <inheritdoc/>
    public override Point2 From => Start;

    /// <inheritdoc/>
    public override Point2 To => End;

    /// <inheritdoc/>
    public override double LengthMm => Start.DistanceTo(End);

    /// <inheritdoc/>
    public override Vector2 DirectionAtStart => (End - Start).Normalize();

    /// <inheritdoc/>
    public override Point2 AtLength(double mm) => Start.Lerp(End, mm / LengthMm);

    /// <inheritdoc/>
    public override DrawnCurve Reversed() => this with { Start = End, End = Start };
}

/// <summary>An arc of a circle, or a whole circle.</summary>
/// <param name="Layer">Its layer.</param>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Center">Its center.</param>
/// <param name="Radius">Its radius, mm.</param>
/// <param name="StartAngle">The direction from the center to its start, radians.</param>
/// <param name="Sweep">The angle that it turns, radians: positive counterclockwise, two pi for a whole circle.</param>
internal sealed record DrawnArc(string Layer, string Entity, Point2 Center, double Radius, double StartAngle, double Sweep)
    : DrawnCurve(Layer, Entity)
{
    /// <summary>True if it is a whole circle.</summary>
    public bool IsCircle => Math.Abs(Sweep) > Math.Tau - 1e-9;

    /// <inheritdoc/>
    public override Point2 From => At(0);

    /// <inheritdoc/>
    public override Point2 To => At(1);

    /// <summary>The place at a share of its sweep.</summary>
    public Point2 At(double share)
    {
        var (sin, cos) = Elementary.SinCos(StartAngle + (share * Sweep));
        return Center + new Vector2(Radius * cos, Radius * sin);
    }

    /// <inheritdoc/>
    public override double LengthMm => Radius * Math.Abs(Sweep);

    /// <inheritdoc/>
    public override Vector2 DirectionAtStart => ((From - Center) / Radius).Left * Math.Sign(Sweep);

    /// <inheritdoc/>
    public override Point2 AtLength(double mm) => At(mm / LengthMm);

    /// <inheritdoc/>
    public override DrawnCurve Reversed() => this with { StartAngle = StartAngle + Sweep, Sweep = -Sweep };
}

/// <summary>A free curve as a polyline that leaves it by no more than <see cref="ChordMm"/>.</summary>
/// <param name="Layer">Its layer.</param>
/// <param name="Entity">What it is in the file.</param>
/// <param name="Points">Two or more places.</param>
internal sealed record DrawnCourse(string Layer, string Entity, IReadOnlyList<Point2> Points) : DrawnCurve(Layer, Entity)
{
    /// <summary>The largest distance of the polyline from its curve, mm.</summary>
    public const double ChordMm = 0.001;

    /// <inheritdoc/>
    public override Point2 From => Points[0];

    /// <inheritdoc/>
    public override Point2 To => Points[^1];

    /// <inheritdoc/>
    public override double LengthMm => Points.Zip(Points.Skip(1), (a, b) => a.DistanceTo(b)).Sum();

    /// <inheritdoc/>
    public override Vector2 DirectionAtStart => (Points[1] - Points[0]).Normalize();

    /// <inheritdoc/>
    public override Point2 AtLength(double mm)
    {
        for (var i = 1; i < Points.Count; i++)
        {
            var length = Points[i - 1].DistanceTo(Points[i]);
            if (mm <= length)
            {
                return Points[i - 1].Lerp(Points[i], length > 0 ? mm / length : 0);
            }

            mm -= length;
        }

        return To;
    }

    /// <inheritdoc/>
    public override DrawnCurve Reversed() => this with { Points = [.. Points.Reverse()] };
}

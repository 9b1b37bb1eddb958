using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The points of one measurement, in millimeters, with their provenance.</summary>
public sealed class MeasurementFile
{
    private const int MostShown = 4;

    private readonly Dictionary<string, LabelledPoint> _byLabel;
    private readonly MeasurementBytes _source;
    private readonly MeasuredContent _content;
    private LabelRule? _rule;
    private IReadOnlyList<LabelledPoint>? _shown;

    internal MeasurementFile(MeasurementBytes source, MeasuredContent content)
    {
        (_source, _content) = (source, content);
        Sha256 = source.Sha256;
        _byLabel = content.Points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        if (content.HasNumbers)
        {
            AddNumbers(content.Points);
        }
    }

    /// <summary>The file name, as given by the caller.</summary>
    public string File => _source.File;

    /// <summary>The files that were read: the named one, and the description of its values (<c>.dfd</c>) if it has one.</summary>
    public IReadOnlyList<string> Files => _source.Files;

    /// <summary>SHA-256 of the bytes as 64 lowercase hexadecimal digits (<see cref="MeasurementBytes.Sha256"/>).</summary>
    public string Sha256 { get; }

    /// <summary>The unit in the file. The points are always in millimeters.</summary>
    public LengthUnit Unit => _content.Unit;

    /// <summary>The measured points in the order of the file.</summary>
    public IReadOnlyList<LabelledPoint> Points => _content.Points;

    /// <summary>The nominal points in the same order; empty if the file does not have all of them.</summary>
    public IReadOnlyList<LabelledPoint> Nominals => _content.Nominals;

    /// <summary>True if the file names no points, so that only their order says which they are. They are called 1, 2, 3 in the order of
    /// the file until <see cref="InOrderOf"/> names them.</summary>
    public bool IsByOrder => _content.IsByOrder;

    /// <summary>True if the points are contacts because the file states the radius of the ball, whatever a job says of its
    /// gauge.</summary>
    public bool IsContact => _content.IsContact;

    /// <summary>The number of the plan that the points were touched by, as a probing program writes it; null if the file names
    /// none.</summary>
    public string? Plan => _content.Plan;

    /// <summary>Whether a point is the center of the stylus ball, in a file that says so of each; null in any other file.</summary>
    /// <param name="label">Name of the point.</param>
    /// <exception cref="InputException">The file has no such point (<see cref="MeasurementError.MissingPoint"/>).</exception>
    public bool? IsCenter(string label) => _content.Centers?.Contains(this[label].Line);

    /// <summary>Names and values of what the file says about itself, in the order of the file: the lines above a table, or the fields
    /// about the part in a format that has such (<c>K1001</c>, <c>PARTID</c>, <c>SerialNumber</c>).</summary>
    public IReadOnlyList<HeaderField> HeaderFields => _content.Fields;

    /// <summary>The measured point with a name.</summary>
    /// <exception cref="InputException">The file has no such point (<see cref="MeasurementError.MissingPoint"/>).</exception>
    public LabelledPoint this[string label] => TryGet(label, out var point) ? point : throw Missing(label);

    /// <summary>Returns the measured point with a name, if there is one.</summary>
    public bool TryGet(string label, out LabelledPoint point) => _byLabel.TryGetValue(label, out point);

    /// <summary>Throws unless the file has all named points.</summary>
    /// <exception cref="InputException">The first missing point (<see cref="MeasurementError.MissingPoint"/>).</exception>
    public void Require(IEnumerable<string> labels)
    {
        foreach (var label in labels)
        {
            _ = this[label];
        }
    }

    /// <summary>The unparsed texts of a column in the order of the file; null if there is no such column.</summary>
    /// <param name="name">Name of the column; case is ignored.</param>
    public IReadOnlyList<string>? ColumnTexts(string name) => _content.Texts(name);

    /// <summary>The same measurement with names for points that have none.</summary>
    /// <param name="labels">The names, in the order in which the points were measured.</param>
    /// <exception cref="InputException">The file has another number of points (<see cref="MeasurementError.PointCount"/>).</exception>
    public MeasurementFile InOrderOf(IReadOnlyList<string> labels)
    {
        ArgumentNullException.ThrowIfNull(labels);
        return labels.Count == Points.Count
            ? new(_source, _content with { Points = [.. Points.Select((p, i) => p with { Label = labels[i] })], IsByOrder = false })
            : throw _content.Labels.Fail(
                MeasurementError.PointCount,
                string.Create(CultureInfo.InvariantCulture, $"{Points.Count} points without labels"),
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{labels.Count}, one for each point in the order of the job: measure all of them once, and nothing else"));
    }

    /// <summary>The same measurement in another frame of the plane XY.</summary>
    /// <param name="transform">From the file's frame to that frame.</param>
    public MeasurementFile Moved(RigidTransform2 transform) => new(
        _source,
        _content with
        {
            Points = [.. Points.Select(p => transform.Apply(new Point2(p.Position.X, p.Position.Y)) is var at
                ? p with { Position = new(at.X, at.Y, p.Position.Z) }
                : p)],
            Nominals = [],
        });

    /// <summary>The same measurement with the labels of a job.</summary>
    /// <param name="rule">The rule by which the file's labels follow from the job's.</param>
    /// <param name="labels">The job's labels.</param>
    /// <exception cref="InputException">A label has no number for the rule, or two get the same name
    /// (<see cref="MeasurementError.BadLabels"/>).</exception>
    public MeasurementFile Renamed(LabelRule rule, IReadOnlyList<string> labels)
    {
        ArgumentNullException.ThrowIfNull(rule);
        ArgumentNullException.ThrowIfNull(labels);
        var own = rule.Invert(labels);

        // A point that has a job's label by chance is not meant: the rule says which one is.
        var named = labels.ToHashSet(StringComparer.Ordinal);
        return new(_source, _content with
        {
            Points = [
                .. Points.Where(p => own.ContainsKey(p.Label) || !named.Contains(p.Label))
                    .Select(p => own.TryGetValue(p.Label, out var label) ? p with { Label = label } : p)],
            Nominals = [],
            HasNumbers = false,
            Incomplete = [.. _content.Incomplete.Select(p => (own.GetValueOrDefault(p.Label, p.Label), p.Axis, p.Place))],
        })
        {
            _rule = rule,
            _shown = Points,
        };
    }

    // P1 is also called 1, unless another point has this name or number.
    private void AddNumbers(IReadOnlyList<LabelledPoint> points)
    {
        foreach (var numbered in points.GroupBy(p => LabelRule.NumberOf(p.Label), StringComparer.Ordinal))
        {
            if (numbered.Key is { } number && numbered.Count() == 1)
            {
                _ = _byLabel.TryAdd(number, numbered.First());
            }
        }
    }

    private InputException Missing(string label)
    {
        if (_content.Incomplete.FirstOrDefault(p => string.Equals(p.Label, label, StringComparison.Ordinal)) is { Label: not null } part)
        {
            return part.Place.Fail(
                MeasurementError.MissingCoordinate,
                $"the point {MeasurementRefusal.Quote(label)} without {part.Axis}",
                "X and Y of each point: measure and export them");
        }

        var wanted = _rule is null ? label : _rule.Apply(label);
        var points = _shown ?? Points;
        var other = points.FirstOrDefault(p => string.Equals(p.Label, wanted, StringComparison.OrdinalIgnoreCase)).Label;
        return _content.Labels.Fail(
            MeasurementError.MissingPoint,
            $"no point {MeasurementRefusal.Quote(wanted)} among the {points.Count} of the file"
                + (other is null ? ": " + Some(points) : $" (but {MeasurementRefusal.Quote(other)})"),
            $"a point {MeasurementRefusal.Quote(wanted)}: measure it, or correct the label"
                + (_rule is null && LabelRule.Between(label, points) is { } rule
                    ? $"; if {MeasurementRefusal.Quote(rule.Apply(label))} is meant, write \"labels\": \"{rule}\" under \"gauge\""
                    : ""));
    }

    // The first labels and the last one.
    private static string Some(IReadOnlyList<LabelledPoint> points) =>
        string.Join(", ", points.Take(MostShown).Select(p => MeasurementRefusal.Quote(p.Label)))
        + (points.Count > MostShown + 1 ? ", ..." : "")
        + (points.Count > MostShown ? " " + MeasurementRefusal.Quote(points[^1].Label) : "");
}

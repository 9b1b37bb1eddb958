using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>A mating job made from a drawing and a program: <c>errormatch job new mating --outline</c>. Coordinates are the
/// drawing's.</summary>
public sealed record OutlineJob
{
    // Limits that somebody has to replace: a drawing does not say them.
    private const string Placeholder = "[-0.05, 0.05]";

    // No word of a program says less, mm; and what turns a meter by less than that, degrees.
    private const int Decimals = 4, DecimalsOfDegrees = 6;

    // In another unit, at least this share of the outline has to be cut before the unit is doubted.
    private const double LeastOther = 0.6;

    // Of many layers, those with the longest outlines are listed and tried.
    private const int MostListed = 24, MostTried = 8;

    // A curve is drawn by chords of about this length, mm, and at most so many.
    private const double ChordMm = 0.5;
    private const int MostChords = 400;

    // Rotations nearer than this to quarter turns are those, degrees: a meter is turned by 5 um. The key points say what that leaves.
    private const double QuarterDegrees = 0.0003;

    /// <summary>Code of the refusal of a drawing that lies on the program in another unit, which is the only value of the refusal:
    /// <c>mm</c> or <c>inch</c>.</summary>
    public const string OtherUnit = "drawing-unit";

    /// <summary>Name of the file of the key points as designed, beside the job.</summary>
    public const string TheoreticalFile = "theoretical.csv";

    private OutlineJob()
    {
    }

    /// <summary>What was wanted.</summary>
    public required OutlineRequest Request { get; init; }

    /// <summary>The program that the outline lies on.</summary>
    public required ReadOnlyMemory<byte> Program { get; init; }

    /// <summary>The job.</summary>
    public required ReadOnlyMemory<byte> Job { get; init; }

    /// <summary>The key points as designed, which belong beside the job as <see cref="TheoreticalFile"/>.</summary>
    public required ReadOnlyMemory<byte> Theoretical { get; init; }

    /// <summary>The layer of the outline.</summary>
    public required string Layer { get; init; }

    /// <summary>Millimeters in the drawing's unit.</summary>
    public required double UnitMm { get; init; }

    /// <summary>From the drawing to the program.</summary>
    public required RigidTransform2 Frame { get; init; }

    /// <summary>Diameter of the tool, mm: given, or found.</summary>
    public required double ToolDiameterMm { get; init; }

    /// <summary>The share of the outline that the program cuts.</summary>
    public required double CoveredShare { get; init; }

    /// <summary>Root mean square of how far the key points are from where the program's tool leaves the boundary, mm.</summary>
    public required double RmsMm { get; init; }

    /// <summary>The largest of it, mm.</summary>
    public required double LargestMm { get; init; }

    /// <summary>The proposed features: name, kind, number of key points and blocks.</summary>
    public required IReadOnlyList<(string Name, FeatureKind Kind, int Points, IReadOnlyList<string> Blocks)> Features { get; init; }

    /// <summary>The limits that the model states, mm, and the names of their annotations, by the names of the features.</summary>
    public IReadOnlyDictionary<string, (double Lower, double Upper, string From)> Limits { get; init; } =
        new Dictionary<string, (double, double, string)>();

    /// <summary>The dimensions and tolerances of the model, with what became of them, in file order; none of a drawing.</summary>
    public IReadOnlyList<OutlineTolerance> Tolerances { get; init; } = [];

    /// <summary>True if nobody named the tool: its diameter is what the outline's distance from the path says.</summary>
    public bool IsToolFound => Request.ToolDiameterMm is null;

    /// <summary>True if the drawing does not say its unit, and millimeters are taken.</summary>
    public required bool IsUnitAssumed { get; init; }

    /// <summary>The number of other ways to lay the outline on the program; this one moves it least.</summary>
    public required int OtherWays { get; init; }

    /// <summary>What was passed over or left out, in sentences.</summary>
    public required IReadOnlyList<string> Remarks { get; init; }

    /// <summary>What may be otherwise, and what was left out, in sentences.</summary>
    public IReadOnlyList<string> Notes
    {
        get
        {
            var notes = new List<string>();
            if (IsToolFound)
            {
                notes.Add(FormattableString.Invariant(
                    $"Nobody named the tool: {ToolDiameterMm:0.###} mm is what the outline's distance from the path says. An allowance or ")
                    + "a gap in the program would be taken for tool: compare, and give --tool-diameter if yours is another.");
            }

            if (IsUnitAssumed)
            {
                notes.Add("The drawing does not say its unit. It fits the program in millimeters.");
            }

            if (OtherWays > 0)
            {
                notes.Add(
                    $"The outline can be laid on the program in {OtherWays + 1} ways or more; this one moves it least. Look at the "
                        + "frame: a wrong one puts every correction at a wrong place.");
            }

            return [.. notes, .. Remarks];
        }
    }

    /// <summary>The files that were read.</summary>
    public required IReadOnlyList<string> Read { get; init; }

    /// <summary>The whole outline as lines, in the frame of the program.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Outline { get; init; } = [];

    /// <summary>The layers of a drawing, one of which mates, with what a program cuts of them.</summary>
    /// <param name="request">The drawing and the program; its layer is not looked at.</param>
    /// <param name="cancellation">Cancels between layers.</param>
    /// <returns>The layers, the longest outline first; a refusal if nothing can be laid on the program at all.</returns>
    /// <exception cref="InputException">As <see cref="Make"/>.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<OutlineLayer[]> LayersOf(OutlineRequest request, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var opened = Open(request, cancellation);
        if (opened.Result is not var (_, cuts, drawing))
        {
            return Outcome.Refused<OutlineLayer[]>(opened.Refusals);
        }

        return Longest(drawing).Index().Select(l =>
        {
            cancellation.ThrowIfCancellationRequested();
            return new OutlineLayer(l.Item, drawing.Curves.Count(c => c.Layer == l.Item), drawing.Places.GetValueOrDefault(l.Item) ?? "")
            {
                IsTried = l.Index < MostTried,
                CoveredShare = l.Index < MostTried ? ShareOf(request, drawing, l.Item, cuts) : null,
            };
        }).ToArray();
    }

    /// <summary>Makes a job.</summary>
    /// <returns>The job; a refusal if the drawing cannot be laid on what the program cuts.</returns>
    /// <exception cref="InputException">A file cannot be opened or read. The layer is not named, or not there.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<OutlineJob> Make(OutlineRequest request, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var opened = Open(request, cancellation);
        if (opened.Result is not var (path, cuts, drawing))
        {
            return Outcome.Refused<OutlineJob>(opened.Refusals);
        }

        var layer = LayerOf(drawing, request, cuts);
        var chains = Chains(drawing, layer);
        var elements = chains.SelectMany(c => c).ToArray();
        if (OutlineLaying.Find(elements, cuts, request.ToolDiameterMm / 2) is not { } laying)
        {
            return NotLaid(request, drawing, layer, cuts);
        }

        var notes = drawing.Notes.ToList();
        laying = laying with { Frame = Rounded(laying.Frame, elements[0].From), RadiusMm = Math.Round(laying.RadiusMm, 3) };
        if (laying.CoveredShare < 0.98)
        {
            notes.Add(FormattableString.Invariant(
                $"The program cuts {laying.CoveredShare:0 %} of the outline; features are proposed there."));
        }

        var features = chains.SelectMany(c => OutlineFeature.Of(c, laying, cuts, notes)).OrderBy(f => f.Motion).Select(f => f.Feature);
        var made = WithBlocks(request, path, cuts, layer, drawing, laying, [.. Named(features)], notes);
        return made.Result is { } job ? job with { Outline = Lines(chains, laying.Frame) }
            : UnitOf(request, drawing, layer, cuts) is { } unit ? unit : made;
    }

    /// <summary>A draft with the outline: its features with their blocks, frame, tool and program. What a drawing does not say stays as
    /// the draft has it. Limits that a model does not state are empty: those of the draft were for other features.</summary>
    /// <param name="draft">The draft.</param>
    public MatingDraft Into(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var made = MatingDraftFiles.Read(Job.Span, Request.Job, Theoretical);
        var taken = draft with
        {
            Name = draft.Name.Trim().Length > 0 ? draft.Name : Path.GetFileNameWithoutExtension(Request.Drawing),
            Features = [.. made.Features.Select(f => Limits.ContainsKey(f.Name) ? f : f with { Lower = "", Upper = "" })],
            OtherPoints = [],
            Program = DraftProgram.Of(Program),
        };

        // What names points that are gone goes with them: alignment, origin, points left out, comparisons, the order of a log's points.
        string[] gone = [
            DraftPaths.Alignment, DraftPaths.OriginCheck, DraftPaths.LeftOut, DraftPaths.Comparisons, DraftPaths.CounterpartMeasured,
            .. draft.Count(DraftPaths.GaugeLabels) > 0 ? [DraftPaths.GaugeLabels] : Array.Empty<string>()];
        return gone.Aggregate(taken, (to, path) => to.Without(path))
            .With(DraftPaths.Program, Path.GetFileName(Request.Program))
            .With(made, DraftPaths.ProgramSha256, DraftPaths.ToolDiameter, DraftPaths.Frame);
    }

    private static Outcome<Opened> Open(OutlineRequest request, CancellationToken cancellation)
    {
        var path = NcInterpreter.Run(
            NcProgram.Read(InputFile.Program(request.Program)),
            request.Control ?? InputFile.Dialect(request.Dialect),
            new ProgramFolder(request.Program, request.Libraries).Find,
            cancellation);
        if (path.Refusal is { } refusal)
        {
            return refusal.In(request.Program);
        }

        var cuts = new CutPath(path);
        if (cuts.IsEmpty)
        {
            return new Refusal(
                "no-cutting-motion",
                $"{request.Program} cuts nothing in the plane XY of which it says where; expected the program that cuts the outline.");
        }

        if (cuts.IsCompensated != false && request.ToolDiameterMm is null)
        {
            throw InputException.At(
                "tool-diameter-missing",
                request.Program,
                "the control offsets the tool there (G41 or G42), so the path does not tell the tool. Give --tool-diameter.");
        }

        return new Opened(path, cuts, Drawing.Read(request.Drawing, request.UnitMm));
    }

    private static IEnumerable<string> Longest(Drawing drawing) => drawing.Curves.GroupBy(c => c.Layer, StringComparer.Ordinal)
        .OrderByDescending(g => g.Sum(c => c.LengthMm)).Select(g => g.Key);

    // What the program cuts of a layer; null if it cannot be laid on the program.
    private static double? ShareOf(OutlineRequest request, Drawing drawing, string layer, CutPath cuts) => OutlineLaying.Find(
        [.. Chains(drawing, layer).SelectMany(c => c)], cuts, request.ToolDiameterMm / 2)?.CoveredShare;

    private static IReadOnlyList<Point2>[] Lines(OutlineElement[][] chains, RigidTransform2 frame) => [
        .. chains.Select(chain => (IReadOnlyList<Point2>)[
            .. chain.SelectMany(e => e.Curves).SelectMany(c =>
            {
                var count = c is DrawnLine ? 1 : Math.Clamp((int)(c.LengthMm / ChordMm), 8, MostChords);
                return Enumerable.Range(0, count + 1).Select(k => frame.Apply(c.AtLength(c.LengthMm * k / count)));
            })])];

    private static OutlineElement[][] Chains(Drawing drawing, string layer) =>
        [.. OutlineChain.Join([.. drawing.Curves.Where(c => c.Layer == layer)]).Select(c => OutlineElement.Of(c).ToArray())];

    // Which one mates is asked and not guessed, also where only one can be laid on the program: a piece has more than one outline.
    private static string LayerOf(Drawing drawing, OutlineRequest request, CutPath cuts)
    {
        string[] all = [.. Longest(drawing)];
        var longest = all.Take(MostListed).ToHashSet(StringComparer.Ordinal);
        var layers = string.Join(", ", drawing.Layers.Where(longest.Contains).Select(l =>
            $"{PrintedText.OneLine(l)} ({ReportNumber.Count(drawing.Curves.Count(c => c.Layer == l), "curve")}"
                + $"{drawing.Places.GetValueOrDefault(l)})"));
        layers += all.Length > MostListed ? $" and {ReportNumber.Count(all.Length - MostListed)} with shorter outlines" : "";
        if (request.Layer is not { } name)
        {
            return drawing.Layers.Count == 1 ? drawing.Layers[0]
                : throw InputException.At(
                    "layer-missing",
                    drawing.File,
                    $"it has the layers {layers}. {Laid()}Name the one that mates by --layer.");
        }

        // A shell takes a # for the begin of a comment.
        return drawing.Layers.Contains(name, StringComparer.Ordinal) ? name
            : drawing.Layers.Contains("#" + name, StringComparer.Ordinal) ? "#" + name
            : throw InputException.At(
                "layer-unknown", drawing.File, $"it has no curve on the layer {PrintedText.OneLine(name)}; expected one of {layers}.");

        string Laid()
        {
            string[] laid = [
                .. all.Take(MostTried).Select(l => (Layer: l, Share: ShareOf(request, drawing, l, cuts))).Where(l => l.Share is not null)
                    .Select(l => string.Create(CultureInfo.InvariantCulture, $"{PrintedText.OneLine(l.Layer)} ({l.Share:0 %})"))];
            return laid.Length == 0 ? "" : $"On what the program cuts, these can be laid: {string.Join(", ", laid)}. ";
        }
    }

    // The same drawing in another unit may be what was meant: then that is said, and not taken.
    private static Refusal? UnitOf(OutlineRequest request, Drawing drawing, string layer, CutPath cuts)
    {
        foreach (var (mm, word) in new[] { (1.0, "mm"), (25.4, "inch") }.Where(u => Math.Abs(u.Item1 - drawing.Unit.Mm) > 1e-9))
        {
            // In a smaller unit, two outlines may be one.
            OutlineElement[] other = [.. Chains(Drawing.Read(request.Drawing, mm), layer).SelectMany(c => c)];
            if (other.Length > 0 && OutlineLaying.Find(other, cuts, request.ToolDiameterMm / 2) is { CoveredShare: > LeastOther })
            {
                var said = drawing.Unit.IsStated ? "says that its unit is" : "does not say its unit; it was tried as";
                return new(
                    OtherUnit,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"{request.Drawing} {said} {drawing.Unit.Mm:0.######} mm, and lies on the program in {word}. If that is "
                            + $"meant, give --unit {word}."))
                {
                    Values = [word],
                };
            }
        }

        return null;
    }

    private static Refusal NotLaid(OutlineRequest request, Drawing drawing, string layer, CutPath cuts) =>
        UnitOf(request, drawing, layer, cuts) ?? new(
            "outline-not-laid",
            $"No way was found to lay the layer {PrintedText.OneLine(layer)} of {request.Drawing} on what {request.Program} cuts: too "
                + "little of it would be one tool radius from the path. Check the layer, the program and --tool-diameter.");

    // A place of the outline stays where it is, so that a rounded turn does not shift what is far from the origin.
    private static RigidTransform2 Rounded(RigidTransform2 frame, Point2 pivot)
    {
        var degrees = Math.Round(frame.Rotation.Degrees, DecimalsOfDegrees);
        var quarter = 90 * Math.Round(degrees / 90);
        degrees = Math.Abs(degrees - quarter) < QuarterDegrees ? quarter : degrees;
        var turned = new RigidTransform2(frame.Mirror, Angle.FromDegrees(degrees == -180 ? 180 : degrees + 0.0), Vector2.Zero);
        var shift = frame.Apply(pivot) - turned.Apply(pivot);
        return turned with { Translation = new(Math.Round(shift.X, Decimals) + 0.0, Math.Round(shift.Y, Decimals) + 0.0) };
    }

    private static IEnumerable<Proposed> Named(IEnumerable<OutlineFeature> features)
    {
        var (counts, label) = (new Dictionary<FeatureKind, int>(), 0);
        foreach (var feature in features)
        {
            counts[feature.Kind] = counts.GetValueOrDefault(feature.Kind) + 1;
            yield return new(
                feature.Kind.Letter + counts[feature.Kind].ToString(CultureInfo.InvariantCulture),
                feature.Kind,
                [.. feature.Lists.Select(l => (IReadOnlyList<(string, Point2)>)[
                    .. l.Select(p => ((++label).ToString(CultureInfo.InvariantCulture), p))])],
                [])
            {
                Elements = feature.Elements,
            };
        }
    }

    // What a match would refuse is not proposed.
    private static Outcome<OutlineJob> WithBlocks(
        OutlineRequest request,
        NcPath path,
        CutPath cuts,
        string layer,
        Drawing drawing,
        OutlineLaying laying,
        Proposed[] features,
        List<string> notes)
    {
        var diameter = request.ToolDiameterMm ?? 2 * laying.RadiusMm;
        SoughtBoundary[] sought = [
            .. features.Select(f => new SoughtBoundary(
                f.Name, CoordinatePlane.XY, [.. f.Points.Select(p => (p.Label, laying.Frame.Apply(p.At)))])
            {
                Kind = f.Kind,
            })];
        var found = BlockProposal.Propose(path, sought, diameter, JobCounterpart.DefaultMapMm);
        var kept = new List<Proposed>();
        for (var f = 0; f < features.Length; f++)
        {
            var candidate = features[f] with { Blocks = found[f].Blocks };
            if ((found[f].Refusal ?? Tried(candidate)) is { } refusal)
            {
                notes.Add($"{features[f].Name} is left out: {refusal.Message}");
                continue;
            }

            kept.Add(candidate);
        }

        if (kept.Count == 0)
        {
            return new Refusal(
                "outline-not-laid", $"No feature can be proposed. {string.Join(" ", notes)}".TrimEnd());
        }

        double[] offs = [.. kept.SelectMany(k => k.Points).Select(
            p => cuts.FootOf(laying.Frame.Apply(p.At), laying.RadiusMm + JobCounterpart.DefaultMapMm) is { } foot
                ? foot.DistanceMm - (foot.IsCompensated ? 0 : laying.RadiusMm)
                : JobCounterpart.DefaultMapMm)];
        var (limits, annotations) = OutlineTolerances.Of(
            drawing, layer, [.. kept.Select(k => new TolerancedFeature(k.Name, k.Kind.Word, k.Elements))], laying, cuts);
        for (var k = 0; k < kept.Count; k++)
        {
            kept[k] = kept[k] with { Limits = limits[k] };
        }

        if (annotations.Count(t => t.UnitMm is { } mm && Math.Abs(mm - 1) > 1e-9) is > 0 and var converted)
        {
            notes.Add(
                $"Converted to millimeters: {ReportNumber.Count(converted, "dimension or tolerance", "dimensions and tolerances")} of the "
                    + "model in another unit.");
        }

        var table = Table(kept.SelectMany(k => k.Points));
        return new OutlineJob
        {
            Request = request,
            Program = path.Program.Bytes,
            Job = Encoding.UTF8.GetBytes(JobText(request, path.Program, laying.Frame, diameter, kept)),
            Theoretical = table,
            Layer = layer,
            UnitMm = drawing.Unit.Mm,
            Frame = laying.Frame,
            ToolDiameterMm = diameter,
            CoveredShare = laying.CoveredShare,
            RmsMm = Math.Sqrt(offs.Average(o => o * o)),
            LargestMm = offs.Max(Math.Abs),
            Features = [.. kept.Select(k => (k.Name, k.Kind, k.Points.Count(), k.Blocks))],
            Limits = kept.Where(k => k.Limits is not null).ToDictionary(
                k => k.Name, k => (k.Limits!.Lower, k.Limits.Upper, k.Limits.From), StringComparer.Ordinal),
            Tolerances = annotations,
            IsUnitAssumed = !drawing.Unit.IsStated,
            OtherWays = laying.Others,
            Remarks = notes,
            Read = [request.Drawing, request.Program],
        };

        Refusal? Tried(Proposed one)
        {
            var job = MatingJob.Parse(Encoding.UTF8.GetBytes(JobText(request, path.Program, laying.Frame, diameter, [one])), request.Job);
            var theoretical = MeasurementReader.Read(Table(one.Points), TheoreticalFile, MeasurementFormat.Points);
            return BoundarySearch.Try(job, path, theoretical, 0, one.Blocks);
        }
    }

    private static byte[] Table(IEnumerable<(string Label, Point2 At)> points) => Encoding.ASCII.GetBytes(
        "point,x_mm,y_mm\n" + string.Concat(points.Select(p => string.Create(
            CultureInfo.InvariantCulture, $"{p.Label},{p.At.X:0.0000##},{p.At.Y:0.0000##}\n"))));

    private static string JobText(
        OutlineRequest request,
        NcProgram program,
        RigidTransform2 frame,
        double diameter,
        IReadOnlyList<Proposed> features)
    {
        // Line numbers mean blocks of this program alone.
        var isByLine = features.SelectMany(f => f.Blocks).Any(b => BlockSelector.Parse(b).IsByLine);
        var sha256 = isByLine ? $"\n    \"programSha256\": \"{DraftProgram.Of(program.Bytes).Sha256}\"," : "";
        var folder = Path.GetDirectoryName(Path.GetFullPath(request.Job))!;
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $$"""
            // A mating job made from {{Path.GetFileName(request.Drawing).ReplaceLineEndings(" ")}}. Millimeters and degrees.
            // To be replaced: {{(features.Any(f => f.Limits is not null)
                ? "the limits (toleranceMm) that are not from the model (toleranceFrom)"
                : "the limits (toleranceMm)")}}, the gauge's uncertainty, and the name of the measured file.
            {
              "kind": "mating",
              "name": {{JsonEdit.Text(Path.GetFileNameWithoutExtension(request.Job))}},
              "part": { "theoretical": "{{TheoreticalFile}}", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": 0.005 },
              "features": [

            """);
        foreach (var feature in features)
        {
            var (name, kind, lists, blocks) = feature;
            var points = lists.Count == 1 ? Labels(lists[0]) : "[" + string.Join(", ", lists.Select(Labels)) + "]";
            text.Append(
                CultureInfo.InvariantCulture,
                $$"""    { "name": {{JsonEdit.Text(name)}}, "kind": "{{kind.Word}}", "points": {{points}}, """)
                .Append(CultureInfo.InvariantCulture, $"\"blocks\": {JsonEdit.List(blocks)}, ")
                .Append(feature.Limits is not { } limits
                    ? $"\"toleranceMm\": {Placeholder} }},"
                    : $"\"toleranceMm\": [{Number(limits.Lower)}, {Number(limits.Upper)}], "
                        + $"\"toleranceFrom\": {JsonEdit.Text(limits.From)} }},")
                .Append('\n');
        }

        return text.Append(CultureInfo.InvariantCulture, $$"""
              ],
              "counterpart": {
                "program": {{JsonEdit.Text(FromFolder(request.Program))}},{{sha256}}
                "dialect": {{JsonEdit.Text(NcDialects.IsFile(request.Dialect) ? FromFolder(request.Dialect) : request.Dialect)}},
                "toolDiameterMm": {{Number(diameter)}},
                "frame": {
                  "mirror": "{{frame.Mirror.ToString().ToLowerInvariant()}}",
                  "rotateDeg": {{Number(frame.Rotation.Degrees)}},
                  "translateMm": [{{Number(frame.Translation.X)}}, {{Number(frame.Translation.Y)}}]
                }
              }
            }

            """).ToString().ReplaceLineEndings("\n");

        static string Labels(IReadOnlyList<(string Label, Point2 At)> list) =>
            JsonEdit.List(list.Count > 2 ? [$"{list[0].Label}..{list[^1].Label}"] : list.Select(p => p.Label));

        static string Number(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);

        string FromFolder(string file) => Path.GetRelativePath(folder, Path.GetFullPath(file)).Replace('\\', '/');
    }

    // What a request names.
    private sealed record Opened(NcPath Path, CutPath Cuts, Drawing Drawing);

    // A feature with its labels; its blocks once they are found.
    private sealed record Proposed(
        string Name,
        FeatureKind Kind,
        IReadOnlyList<IReadOnlyList<(string Label, Point2 At)>> Lists,
        IReadOnlyList<string> Blocks)
    {
        public required IReadOnlyList<OutlineElement> Elements { get; init; }

        public OutlineLimits? Limits { get; init; }

        public IEnumerable<(string Label, Point2 At)> Points => Lists.SelectMany(l => l);
    }
}

/// <summary>A layer of a drawing, which may be the outline that mates.</summary>
/// <param name="Name">Its name; of a STEP file the number of a flat face.</param>
/// <param name="Curves">The number of its curves.</param>
/// <param name="Place">Where it is, as the end of a sentence: <c> at Z 10 mm</c>; empty if nothing is known of that.</param>
public sealed record OutlineLayer(string Name, int Curves, string Place)
{
    /// <summary>True if it was laid on the program: only some of many are.</summary>
    public bool IsTried { get; init; }

    /// <summary>The share of its length that the program cuts; null if it cannot be laid on the program, or was not tried.</summary>
    public double? CoveredShare { get; init; }
}

/// <summary>A mating job that is wanted from a drawing and a program.</summary>
/// <param name="Job">The job to write.</param>
/// <param name="Drawing">The drawing: a DXF or STEP file.</param>
/// <param name="Program">The counterpart's program.</param>
/// <param name="Dialect">The control that the program is written for: a built-in dialect, or a shop's dialect file.</param>
public sealed record OutlineRequest(string Job, string Drawing, string Program, string Dialect)
{
    /// <summary>The layer with the outline that mates; null for the only one. In a STEP file it is a flat face: <c>#45</c> or
    /// <c>45</c>.</summary>
    public string? Layer { get; init; }

    /// <summary>Diameter of the tool, mm; null to find it by the distance of the outline from the path.</summary>
    public double? ToolDiameterMm { get; init; }

    /// <summary>Millimeters in the drawing's unit; null if the drawing says it.</summary>
    public double? UnitMm { get; init; }

    /// <summary>The dialect with what is stated of the machine; null for <see cref="Dialect"/> as it is.</summary>
    public NcDialect? Control { get; init; }

    /// <summary>Folders with programs that this one calls.</summary>
    public IReadOnlyList<string> Libraries { get; init; } = [];

    /// <summary>The request of a draft: its control with what is stated of it, and the tool that somebody named for an empty job. Another
    /// one belongs to its own program.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="job">The job's file, for relative paths.</param>
    /// <param name="drawing">The drawing.</param>
    /// <param name="program">The counterpart's program.</param>
    /// <exception cref="InputException">The dialect cannot be opened or used.</exception>
    public static OutlineRequest For(MatingDraft draft, string job, string drawing, string program)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var folder = Path.GetDirectoryName(Path.GetFullPath(job))!;
        var dialect = draft[DraftPaths.Dialect];
        var isEmpty = draft is { IsBegunAnew: true, Program: null, Features.Count: 0 };
        return new(job, drawing, program, NcDialects.IsFile(dialect) ? Path.Combine(folder, dialect) : dialect)
        {
            ToolDiameterMm = isEmpty && DraftNumber.Value(draft[DraftPaths.ToolDiameter]) is > 0 and var mm ? mm : null,
            Control = MatingDraftCheck.DialectOf(draft, job),
            Libraries = [.. draft.Document.Parts(DraftPaths.Libraries).Select(l => Path.Combine(folder, l.Text))],
        };
    }
}

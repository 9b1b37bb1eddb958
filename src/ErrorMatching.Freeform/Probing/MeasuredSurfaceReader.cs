using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Reads the measured points of a surface: a probing program's log, or a gauge's file.</summary>
/// <remarks>A log starts with the word ERRORMATCH. A gauge's file has the format of the job (<see cref="JobMeasuring.Format"/>), as in
/// mating. It names points by their numbers (12, P12) or by their places in the plan (<c>i,j</c>). Centers of the ball are converted to
/// contacts: the center minus the ball's radius along the normal at the foot of the center on the nominal surface. This is
/// exact wherever the ball touched, also on a slope.</remarks>
public static class MeasuredSurfaceReader
{
    /// <summary>Maximum size of a log in bytes.</summary>
    public const int MaxBytes = 1 << 26;

    private const string UnknownPoint = "unknown-point";
    private const string ContradictoryPoint = "contradictory-point";
    private const string MissingPoint = "missing-point";
    private const string FarOffPoint = "far-off-point";
    private const double RoundingMm = 0.005;

    /// <summary>Reads the measured points of a plan from the bytes of one file, as in the other overload.</summary>
    /// <param name="bytes">The file's bytes.</param>
    /// <param name="file">The file name, for messages.</param>
    /// <param name="plan">The measured plan.</param>
    /// <param name="measuring">The format and content of the file.</param>
    /// <exception cref="InputException">The file cannot be used.</exception>
    public static MeasuredPoints Read(ReadOnlySpan<byte> bytes, string file, MeasuringPlan plan, JobMeasuring measuring) =>
        Read(new MeasurementBytes(file, bytes.ToArray()), plan, measuring);

    /// <summary>Reads the measured points of a plan.</summary>
    /// <param name="source">The file.</param>
    /// <param name="plan">The measured plan.</param>
    /// <param name="measuring">The format and content of the file (<see cref="JobMeasuring.Format"/>,
    /// <see cref="JobMeasuring.ReportsStylusCenter"/>), and approach and overtravel, which limit the distance from the expected
    /// surface.</param>
    /// <exception cref="InputException">The file cannot be read; a planned point is missing (<c>missing-point</c>) or occurs twice
    /// (<c>doubled-point</c>); a point is unknown to the plan (<c>unknown-point</c>), at another place in it
    /// (<c>contradictory-point</c>), or too far from the expected place (<c>far-off-point</c>). The points lie on the surface at other
    /// places than the plan's (<c>own-grid</c>). The file does not follow its format
    /// (a code of <see cref="MeasurementError"/>).</exception>
    public static MeasuredPoints Read(MeasurementBytes source, MeasuringPlan plan, JobMeasuring measuring)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(plan);
        ArgumentNullException.ThrowIfNull(measuring);
        var (file, bytes) = (source.File, source.Bytes);
        string? cutBy = null;
        var raw = IsLog(bytes.Span, file)
            ? Log(bytes.Span, file, plan, out cutBy)
            : Gauge(MeasurementReader.Read(source, measuring.Format), plan, measuring);
        try
        {
            return InPlan(source, plan, measuring, raw, cutBy);
        }
        catch (InputException e) when (e.Code is UnknownPoint or ContradictoryPoint or MissingPoint or FarOffPoint
            && OwnGrid.Of(raw, plan, LimitOf(measuring)) is { } why)
        {
            throw InputException.At(
                "own-grid", file, $"the points lie on the surface, {why}. Use the plan that errormatch surface plan writes.");
        }
    }

    // A log without labels has the points of the plan in its order. One with the radius of its ball was read as contacts.
    private static IReadOnlyList<RawPoint> Gauge(MeasurementFile file, MeasuringPlan plan, JobMeasuring measuring) =>
        new MeasuredPointNames(
            file.IsByOrder ? file.InOrderOf([.. plan.Points.Select(p => Whole(p.Number))]) : file,
            measuring.ReportsStylusCenter && !file.IsContact).Read();

    private static MeasuredPoints InPlan(
        MeasurementBytes source, MeasuringPlan plan, JobMeasuring measuring, IReadOnlyList<RawPoint> raw, string? cutBy)
    {
        var file = source.File;
        var found = new RawPoint?[plan.Points.Count];
        var warnings = new List<ReportWarning>();
        var places = plan.Points.ToDictionary(p => (p.I, p.J), p => p.Number);
        var before = 0;
        foreach (var point in raw)
        {
            var number = NumberOf(point, places, plan, file);
            if (found[number - 1] is { } first)
            {
                throw InputException.At(
                    "doubled-point",
                    file,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"point {number} is here a second time, the first is in line {first.Line}. Delete the one that does not count."),
                    point.Line);
            }

            if (point.Number is not null && number < before && warnings.Count == 0)
            {
                warnings.Add(
                    ReportWarning.Of(SurfaceWarningForms.OutOfOrder, file, Whole(point.Line), Whole(number), Whole(before)));
            }

            found[number - 1] = point;
            before = number;
        }

        Missing(found, file);
        var points = plan.Points.Select((p, k) => new MeasuredPoint(p, Contact(p, found[k]!, plan, file), found[k]!.Line)).ToArray();
        FarOff(points, plan, measuring, found, file);
        return new(file, source.Sha256, points, warnings) { CutByMeasurement = cutBy };
    }

    private static double LimitOf(JobMeasuring measuring) => Math.Min(measuring.ApproachMm, measuring.OvertravelMm) - RoundingMm;

    private static string Whole(int number) => number.ToString(CultureInfo.InvariantCulture);

    // Controls put lines of their own around a log, which begin with a percent sign or a semicolon.
    private static bool IsLog(ReadOnlySpan<byte> bytes, string file)
    {
        bytes = bytes.StartsWith("\uFEFF"u8) ? bytes["\uFEFF"u8.Length..] : bytes;
        while (bytes.Length > 0)
        {
            var end = bytes.IndexOfAny((byte)'\n', (byte)'\r');
            var line = (end < 0 ? bytes : bytes[..end]).Trim(" \t"u8);
            if (line.Length > 0 && line[0] is not ((byte)'%' or (byte)';'))
            {
                return line.StartsWith("ERRORMATCH"u8);
            }

            bytes = end < 0 ? [] : bytes[(end + 1)..];
        }

        throw InputException.At("empty-file", file, "the file is empty; a log, or a table with a header, is expected.");
    }

    private static IReadOnlyList<RawPoint> Log(ReadOnlySpan<byte> bytes, string file, MeasuringPlan plan, out string? cutBy)
    {
        if (bytes.Length > MaxBytes)
        {
            throw InputException.At(
                MeasurementError.FileTooLarge,
                file,
                FormattableString.Invariant($"found a log of {bytes.Length} bytes; at most {MaxBytes} are read. Is this the right file?"));
        }

        var log = new ProbingLogReader(file, plan);
        var points = log.Read(TextOf(bytes, file).ReplaceLineEndings("\n").Split('\n'));
        cutBy = log.CutByMeasurement;
        return points;
    }

    private static int NumberOf(RawPoint point, Dictionary<(int I, int J), int> places, MeasuringPlan plan, string file)
    {
        if (point.Number is { } number)
        {
            if (number < 1 || number > plan.Points.Count)
            {
                throw InputException.At(
                    UnknownPoint,
                    file,
                    FormattableString.Invariant($"found point {number}; the plan has the points 1 to {plan.Points.Count}."),
                    point.Line);
            }

            var planned = plan.Points[number - 1];
            return point.I is null || (point.I == planned.I && point.J == planned.J)
                ? number
                : throw InputException.At(
                    ContradictoryPoint,
                    file,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"found point {number} with i {point.I}, j {point.J}; in the plan it is i {planned.I}, j {planned.J}. Delete the "
                            + $"column point, or the columns i and j, whichever is wrong."),
                    point.Line);
        }

        return point is { I: { } i, J: { } j } && places.TryGetValue((i, j), out var found)
            ? found
            : throw InputException.At(
                UnknownPoint,
                file,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"found the point i {point.I}, j {point.J}; the plan has i from 0 to {plan.Points.Max(p => p.I)} and j from 0 to "
                        + $"{plan.Points.Max(p => p.J)}."),
                point.Line);
    }

    private static void Missing(RawPoint?[] found, string file)
    {
        var missing = Enumerable.Range(1, found.Length).Where(n => found[n - 1] is null).ToArray();
        if (missing.Length > 0)
        {
            var shown = string.Join(", ", missing.Take(10).Select(n => n.ToString(CultureInfo.InvariantCulture)))
                + (missing.Length > 10 ? ", ..." : "");
            throw InputException.At(
                MissingPoint,
                file,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{missing.Length} of the plan's {found.Length} points are missing: {shown}. Measure them, or make a plan without "
                        + $"them."));
        }
    }

    private static Point3 Contact(PlanPoint planned, RawPoint raw, MeasuringPlan plan, string file)
    {
        if (!raw.IsCenter)
        {
            return raw.Position;
        }

        var foot = NormalFoot.Find(plan.Surface.Spline, raw.Position, planned.U, planned.V)
            ?? throw InputException.At(
                FarOffPoint,
                file,
                FormattableString.Invariant(
                    $"point {planned.Number} is so far from the surface that no normal of it goes through its center."),
                raw.Line);
        return raw.Position + (plan.Surface.NormalOf(foot) * -plan.StylusRadiusMm);
    }

    // Where the measuring move cannot have been, or has missed.
    private static void FarOff(MeasuredPoint[] points, MeasuringPlan plan, JobMeasuring measuring, RawPoint?[] found, string file)
    {
        // If the move misses, the log contains its rounded end.
        var limit = LimitOf(measuring);
        var far = points.Where(p => (p.Contact - plan.ContactOf(p.Planned)).Length >= limit).ToArray();
        if (far.Length == 0)
        {
            return;
        }

        var first = far[0];
        var off = first.Contact - plan.ContactOf(first.Planned);
        var along = off.Dot(first.Planned.Normal);
        var isRadius = !found[first.Planned.Number - 1]!.IsCenter && Math.Abs(along - plan.StylusRadiusMm) < limit / 4;
        var hint = AxisOrder.Fitting(
                AxisOrder.InSpace,
                [.. points.Select(p => p.Contact)],
                [.. points.Select(p => plan.ContactOf(p.Planned))],
                limit) is { } order
                ? $"Read as {order.Name}, all points are where they are expected: "
                    + "are columns exchanged, or does an axis point the other way?"
            : isRadius ? "This is the radius of the ball: does the file hold centers (\"reports\": \"stylus-center\")?"
            : far.Length == points.Length
                ? "All points are: is the file of another piece, work offset or tool length, or is the surface not where the job has it?"
            : "Measure it again.";
        var others = far.Length switch
        {
            1 => "",
            2 => " 1 other point is beyond that, too.",
            _ => string.Create(CultureInfo.InvariantCulture, $" {far.Length - 1} other points are beyond that, too."),
        };
        throw InputException.At(
            FarOffPoint,
            file,
            string.Create(
                CultureInfo.InvariantCulture,
                $"point {first.Planned.Number} is {PlaceText.Mm(off.Length, 4)} mm from where it is expected ({PlaceText.Mm(along, 3)} "
                    + $"mm along the normal; {PlaceText.Words(new(off.X, off.Y, off.Z))}), and the measuring move reaches less than "
                    + $"{limit:0.####} mm.{others} {hint}"),
            first.Line);
    }

    private static string TextOf(ReadOnlySpan<byte> bytes, string file)
    {
        try
        {
            var text = new UTF8Encoding(false, true).GetString(bytes).TrimStart('\uFEFF');
            return text.Contains('\0', StringComparison.Ordinal)
                ? throw InputException.At("binary-file", file, "found a NUL character; expected text.")
                : text;
        }
        catch (DecoderFallbackException)
        {
            throw InputException.At("invalid-encoding", file, "found bytes that are no UTF-8 text; expected UTF-8.");
        }
    }
}

using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The small program that brings a control's offsets to given corrections.</summary>
/// <remarks>It keeps in the control's variables what each offset was without a correction, and the correction in all. What it sets is the
/// sum of the two, so that it may be stopped anywhere and run again; a third variable says that it was stopped in between. It stops by
/// itself if somebody changed a corrected offset by hand, if the correction before is another one than expected, or if a step is too
/// large. It is a subprogram: a program that calls it goes on behind the call.</remarks>
public static class OffsetProgram
{
    /// <summary>Number of variables that it keeps values in.</summary>
    public const int Variables = OffsetRule.Variables;

    /// <summary>True if a control's radius offsets can be corrected.</summary>
    public static bool CanChangeRadius(NcDialect dialect) => dialect.Offsets.Program.Count > 0 && dialect.Offsets.Radius.Count > 0;

    /// <summary>True if a control's radius offsets belong to tools.</summary>
    public static bool NeedsTool(NcDialect dialect) => dialect.Offsets.Radius.Any(l => l.Contains("{tool}", StringComparison.Ordinal));

    /// <summary>True if a control's work offsets can be corrected.</summary>
    public static bool CanShift(NcDialect dialect) => dialect.Offsets.Program.Count > 0 && dialect.Offsets.Work.Count > 0;

    /// <summary>True if they can be rotated, too.</summary>
    public static bool CanRotate(NcDialect dialect) =>
        CanShift(dialect) && dialect.Offsets.Work.Any(l => l.Contains("{rotation}", StringComparison.Ordinal));

    /// <summary>Number of a work offset in the control's list, from 1; 0 if it is not in it.</summary>
    /// <param name="dialect">The dialect.</param>
    /// <param name="tenths">Its code times ten: 540 is G54.</param>
    public static int NumberOf(NcDialect dialect, int tenths)
    {
        for (var i = 0; i < dialect.Offsets.Codes.Count; i++)
        {
            if (dialect.Offsets.Codes[i] == tenths)
            {
                return i + 1;
            }
        }

        return 0;
    }

    /// <summary>The names at the head of the program: what the control will call it.</summary>
    /// <param name="dialect">The control.</param>
    /// <param name="file">Name of its file.</param>
    /// <param name="programNumber">Number of the program, where programs have one.</param>
    public static IReadOnlyList<string> HeadsOf(NcDialect dialect, string file, int programNumber)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        var values = new Dictionary<string, string>(NamesOf(file), StringComparer.Ordinal) { ["program"] = Text(programNumber, "0000") };
        var lines = dialect.Offsets.Program.Where(l => l != "{body}").SelectMany(l => Filled([l], values, false));
        return ProgramHeads.Of(NcProgram.Read(Encoding.ASCII.GetBytes(string.Join('\n', lines)), dialect.Syntax), dialect);
    }

    /// <summary>The name that its file gets beside a program.</summary>
    /// <param name="dialect">The control.</param>
    /// <param name="programFile">Name of the file of the program that cuts.</param>
    public static string FileBeside(NcDialect dialect, string programFile)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(programFile);
        var name = Named("offsets");
        return name.Equals(Path.GetFileName(programFile), StringComparison.OrdinalIgnoreCase) ? Named("errormatch_offsets") : name;

        string Named(string stem) =>
            dialect.Offsets.File.Length > 0 ? Filled(dialect.Offsets.File, NamesOf(stem)) : stem + Path.GetExtension(programFile);
    }

    /// <summary>The block by which another program calls it; null if the dialect states none, or if the control does not find a file of
    /// this name.</summary>
    /// <param name="dialect">The control.</param>
    /// <param name="file">Name of its file.</param>
    /// <param name="programNumber">Number of the program, where programs have one.</param>
    public static string? CallOf(NcDialect dialect, string file, int programNumber)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(file);
        return dialect.Offsets.Call.Length > 0 && (FileToCall(dialect, file) ?? file) == file
            ? Filled(dialect.Offsets.Call, new(NamesOf(file), StringComparer.Ordinal) { ["program"] = Text(programNumber, "0000") })
            : null;
    }

    /// <summary>The name that a file of the program must have so that the control finds it; null if the name does not matter.</summary>
    /// <param name="dialect">The control.</param>
    /// <param name="file">The name that the file has.</param>
    public static string? FileToCall(NcDialect dialect, string file)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return dialect.Offsets is { Call.Length: > 0, File.Length: > 0 } ? Filled(dialect.Offsets.File, NamesOf(file)) : null;
    }

    /// <summary>Writes the program.</summary>
    /// <param name="dialect">The control.</param>
    /// <param name="radius">The correction of a radius; null if none is made.</param>
    /// <param name="work">The correction of a work offset; null if none is made.</param>
    /// <param name="limits">The largest steps, which the program checks.</param>
    /// <param name="firstVariable">The first of the variables in which it keeps values.</param>
    /// <param name="programNumber">Number of the program, where programs have one.</param>
    /// <param name="file">Name of its file, from which calls get the name of the program where programs have one.</param>
    public static byte[] Write(
        NcDialect dialect,
        RadiusCorrection? radius,
        WorkOffsetCorrection? work,
        OffsetLimits limits,
        int firstVariable,
        int programNumber,
        string file)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(limits);
        ArgumentNullException.ThrowIfNull(file);
        var values = new Dictionary<string, string>(NamesOf(file), StringComparer.Ordinal) { ["program"] = Text(programNumber, "0000") };
        for (var i = 0; i < Variables; i++)
        {
            values[Text(i, "'m'0")] = Text(firstVariable + i, "0");
        }

        values["step"] = Text(limits.StepMm);
        values["stepDegrees"] = Text(limits.StepDegrees);
        var body = new List<string>();
        if (radius is not null)
        {
            var own = new Dictionary<string, string>(values, StringComparer.Ordinal)
            {
                ["number"] = Text(radius.Number, "0"),
                ["tool"] = Text(radius.Tool, "0"),
                ["radius"] = Text(radius.TotalMm),
            };
            if (radius.BeforeMm is { } before)
            {
                own["radiusBefore"] = Text(before);
            }

            body.AddRange(Filled(dialect.Offsets.Radius, own, radius.BeforeMm is not null));
        }

        if (work is not null)
        {
            var own = new Dictionary<string, string>(values, StringComparer.Ordinal)
            {
                ["number"] = Text(work.Number, "0"),
                ["x"] = Text(work.Total.XMm),
                ["y"] = Text(work.Total.YMm),
                ["rotation"] = Text(work.Total.RotationDegrees),
            };
            if (work.Before is { } before)
            {
                (own["xBefore"], own["yBefore"], own["rotationBefore"]) =
                    (Text(before.XMm), Text(before.YMm), Text(before.RotationDegrees));
            }

            body.AddRange(Filled(dialect.Offsets.Work, own, work.Before is not null));
        }

        var lines = dialect.Offsets.Program.SelectMany(l => l == "{body}" ? body : [.. Filled([l], values, false)]);
        return Encoding.ASCII.GetBytes(string.Concat(lines.Select(l => l + "\n")));
    }

    // What no control takes in the name of a program becomes an underscore.
    private static Dictionary<string, string> NamesOf(string file)
    {
        var name = string.Concat(Path.GetFileNameWithoutExtension(file).Select(c => char.IsAsciiLetterOrDigit(c) ? c : '_'));
        return new(StringComparer.Ordinal) { ["name"] = name.ToLowerInvariant(), ["NAME"] = name.ToUpperInvariant() };
    }

    // Lines with values in place of names in braces; those that begin with a question mark only if the correction before is known.
    private static IEnumerable<string> Filled(
        IReadOnlyList<string> lines, Dictionary<string, string> values, bool isKnownBefore) =>
        lines.Where(l => isKnownBefore || !l.StartsWith('?')).Select(l => Filled(l.StartsWith('?') ? l[1..] : l, values));

    private static string Filled(string line, Dictionary<string, string> values) => OffsetRule.NamesIn(line)
        .Aggregate(line, (text, name) => text.Replace($"{{{name}}}", values[name], StringComparison.Ordinal));

    private static string Text(int value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

    private static string Text(decimal value) => value.ToString("0.0#######", CultureInfo.InvariantCulture);
}

/// <summary>A correction of a work offset: a turn about its origin, and a shift, both in the XY plane.</summary>
/// <param name="Number">Number of the work offset; 1 for the control's first one (G54).</param>
/// <param name="Total">The correction in all.</param>
/// <param name="Before">The correction that must be there before; null if any may be.</param>
public sealed record WorkOffsetCorrection(int Number, OffsetShift Total, OffsetShift? Before);

/// <summary>A turn about the origin, then a shift, in the XY plane.</summary>
/// <param name="XMm">Shift in X, mm.</param>
/// <param name="YMm">Shift in Y, mm.</param>
/// <param name="RotationDegrees">Turn, degrees, counterclockwise.</param>
public readonly record struct OffsetShift(decimal XMm, decimal YMm, decimal RotationDegrees);

/// <summary>A correction of the radius with which a control compensates a tool.</summary>
/// <param name="Number">Number of the offset (D; the edge where offsets belong to a tool).</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="TotalMm">The correction in all, mm; positive moves the tool away from the contour.</param>
/// <param name="BeforeMm">The correction that must be there before; null if any may be.</param>
public sealed record RadiusCorrection(int Number, int Tool, decimal TotalMm, decimal? BeforeMm);

/// <summary>How far corrections by offsets may go.</summary>
/// <param name="StepMm">Largest change of one offset by one program, mm.</param>
/// <param name="TotalMm">Largest correction of one offset in all, mm.</param>
/// <param name="StepDegrees">Largest change of a rotation by one program, degrees.</param>
/// <param name="TotalDegrees">Largest rotation in all, degrees.</param>
public sealed record OffsetLimits(decimal StepMm, decimal TotalMm, decimal StepDegrees, decimal TotalDegrees)
{
    /// <summary>0.05 mm and 0.02 degrees in a step, four times that in all.</summary>
    public static OffsetLimits Default { get; } = new(0.05m, 0.2m, 0.02m, 0.08m);
}

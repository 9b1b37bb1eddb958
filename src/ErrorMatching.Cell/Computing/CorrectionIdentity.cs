using System.Globalization;
using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The identity of a correction. Two corrections with the same identity have the same program, and one of them is
/// enough.</summary>
/// <remarks>SHA-256 over lines of UTF-8 text, each ended by a line feed: <c>errormatch/correction/1</c>, <c>measurement HASH</c> for each
/// measurement in their order, <c>job HASH</c>, <c>base HASH</c> or <c>base -</c>, and <c>gain NUMBER</c> or <c>gain -</c>.</remarks>
internal static class CorrectionIdentity
{
    private const int Digits = 64;

    /// <summary>The identity as 64 lower-case hexadecimal digits.</summary>
    /// <param name="measurements">SHA-256 of each measurement, the compensated one first, and of the report before for a job that
    /// accumulates.</param>
    /// <param name="jobSha256">SHA-256 of the job (<see cref="OfJob"/>).</param>
    /// <param name="baseSha256">SHA-256 of the base program; null if the program is generated.</param>
    /// <param name="gain">The gain that replaces the job's; null for the job's own.</param>
    /// <exception cref="ArgumentException">There is no measurement, or a hash is malformed.</exception>
    public static string Of(IReadOnlyList<string> measurements, string jobSha256, string? baseSha256, double? gain)
    {
        ArgumentNullException.ThrowIfNull(measurements);
        if (measurements.Count == 0)
        {
            throw new ArgumentException("A correction without a measurement has no identity.", nameof(measurements));
        }

        var text = new StringBuilder("errormatch/correction/1\n");
        foreach (var measurement in measurements)
        {
            text.Append("measurement ").Append(Hash(measurement)).Append('\n');
        }

        text.Append("job ").Append(Hash(jobSha256)).Append('\n');
        text.Append("base ").Append(baseSha256 is null ? "-" : Hash(baseSha256)).Append('\n');
        text.Append("gain ").Append(gain?.ToString("R", CultureInfo.InvariantCulture) ?? "-").Append('\n');
        return ContentHash.Sha256OfText(text.ToString());
    }

    /// <summary>SHA-256 over a job's file and the files that it names, so that a change to any of them gives another correction: lines
    /// <c>job HASH</c> and <c>ROLE HASH</c>.</summary>
    /// <param name="jobSha256">SHA-256 of the job's file.</param>
    /// <param name="inputs">The files that were read; measurements, programs and the report before are excluded because the
    /// identity covers them separately.</param>
    internal static string OfJob(string jobSha256, IEnumerable<ReportInput> inputs)
    {
        var text = new StringBuilder("job ").Append(Hash(jobSha256)).Append('\n');
        foreach (var input in inputs.Where(
            i => i.Role is not ("part" or "counterpart" or "measured" or "program" or "cut-by" or "previous")))
        {
            text.Append(input.Role).Append(' ').Append(Hash(input.Sha256)).Append('\n');
        }

        return ContentHash.Sha256OfText(text.ToString());
    }

    private static string Hash(string sha256) => sha256.Length == Digits && sha256.All(c => c is (>= '0' and <= '9') or (>= 'a' and <= 'f'))
        ? sha256
        : throw new ArgumentException($"Found {sha256}; expected a SHA-256 of {Digits} lower-case hexadecimal digits.", nameof(sha256));
}

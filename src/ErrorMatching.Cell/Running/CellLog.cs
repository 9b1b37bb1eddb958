using System.Globalization;
using Serilog;
using Serilog.Core;
using Serilog.Events;
using Serilog.Formatting.Json;

namespace ErrorMatching.Cell;

/// <summary>The log of a cell: JSON lines in files that roll daily, and readable text on standard error. It names files, corrections and
/// machines, never a password or a program's content.</summary>
public static class CellLog
{
    internal const long MostBytesOfFile = 50L << 20;
    internal const int MostFiles = 60;

    /// <summary>Opens the log: every step in the files, and what people want to know on standard error.</summary>
    /// <param name="folder">Folder for its files; created if missing.</param>
    /// <returns>The log; the caller must dispose of it so that nothing is lost.</returns>
    public static Logger Open(string folder) => Open(folder, MostBytesOfFile, MostFiles);

    internal static Logger Open(string folder, long mostBytesOfFile, int mostFiles)
    {
        ArgumentNullException.ThrowIfNull(folder);
        return new LoggerConfiguration()
            .MinimumLevel.Debug()
            .WriteTo.File(
                new JsonFormatter(renderMessage: true, formatProvider: CultureInfo.InvariantCulture),
                Path.Combine(folder, "cell-.jsonl"),
                rollingInterval: RollingInterval.Day,
                fileSizeLimitBytes: mostBytesOfFile,
                rollOnFileSizeLimit: true,
                retainedFileCountLimit: mostFiles)
            .WriteTo.Console(
                new CellLogLines(), restrictedToMinimumLevel: LogEventLevel.Information, standardErrorFromLevel: LogEventLevel.Verbose)
            .CreateLogger();
    }
}

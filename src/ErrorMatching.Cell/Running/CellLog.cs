using System.Globalization;
using ErrorMatching.Jobs;
using Serilog;
using Serilog.Core;
using Serilog.Events;
using Serilog.Formatting;
using Serilog.Formatting.Display;
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

/// <summary>The log for people: time, level and message on one line each, whatever characters a file name contains.</summary>
internal sealed class CellLogLines : ITextFormatter
{
    private readonly MessageTemplateTextFormatter _line = new("{Timestamp:HH:mm:ss} {Level:w3} {Message:l}", CultureInfo.InvariantCulture);

    public void Format(LogEvent logEvent, TextWriter output)
    {
        using var line = new StringWriter(CultureInfo.InvariantCulture);
        _line.Format(logEvent, line);
        output.Write(PrintedText.OneLine(line.ToString()) + "\n");
        if (logEvent.Exception is { } defect)
        {
            output.Write(defect + "\n");
        }
    }
}

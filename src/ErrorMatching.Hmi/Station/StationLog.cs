using System.Globalization;
using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Hmi;

/// <summary>What the station has to say outside its window: on the error stream, and where a program has none, as on Windows, in a
/// file.</summary>
public sealed class StationLog
{
    /// <summary>From this size on, a log is kept under its second name and begun again.</summary>
    internal const int MostBytes = 1_000_000;

    /// <summary>So many characters of a sentence are shown: a window of the system grows with its text, beyond the screen.</summary>
    internal const int MostShown = 400;

    private readonly string? _file;
    private readonly TextWriter _error;
    private readonly Action<string>? _show;
    private readonly TimeProvider _clock;

    /// <summary>Opens it.</summary>
    /// <param name="file">The file; null for none. Missing folders are created.</param>
    /// <param name="error">The error stream.</param>
    /// <param name="show">Shows a sentence in a window and waits until it is closed; null where the error stream is seen.</param>
    /// <param name="clock">Stamps each line of the file.</param>
    public StationLog(string? file, TextWriter error, Action<string>? show, TimeProvider clock) =>
        (_file, _error, _show, _clock) = (file, error, show, clock);

    /// <summary>The file of this account: <c>%LOCALAPPDATA%\errormatch\station.log</c>; null for an account without such a
    /// folder.</summary>
    public static string? FileOfAccount =>
        Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData) is { Length: > 0 } folder
            ? Path.Combine(folder, "errormatch", "station.log")
            : null;

    /// <summary>Writes a line.</summary>
    public void Tell(string line)
    {
        _error.WriteLine(line);
        _ = Stored(line);
    }

    /// <summary>Writes what went wrong and when. The lines of the file have a time anyway.</summary>
    public void Warn(string sentence)
    {
        _error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{_clock.GetLocalNow():HH:mm:ss} wrn {sentence}"));
        _ = Stored("wrn " + sentence);
    }

    /// <summary>Writes why the station does not start, and shows the first line of it with the place of the file, which has the
    /// rest.</summary>
    public void Fail(string sentence)
    {
        ArgumentNullException.ThrowIfNull(sentence);
        _error.WriteLine(sentence);
        var isStored = Stored(sentence);
        var first = sentence.Trim().Split('\n')[0].TrimEnd();
        var shown = first.Length <= MostShown ? first : first[..MostShown] + "…";
        _show?.Invoke(isStored ? $"{shown}\n\n{_file}" : shown);
    }

    // A disk that takes no log is no reason to stop.
    private bool Stored(string line)
    {
        if (_file is null)
        {
            return false;
        }

        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(_file))!);
            if (new FileInfo(_file) is { Exists: true, Length: > MostBytes })
            {
                SharedFile.Replace(_file, _file + ".old");
            }

            // Other stations of the same account write to it as well.
            using var stream = new FileStream(_file, FileMode.Append, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete);
            stream.Write(Encoding.UTF8.GetBytes(
                string.Create(CultureInfo.InvariantCulture, $"{_clock.GetLocalNow():yyyy-MM-dd HH:mm:ss} {line}\n")));
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            _error.WriteLine(e.Message);
            return false;
        }
    }
}

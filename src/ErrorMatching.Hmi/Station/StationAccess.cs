using ErrorMatching.Cell;
using ErrorMatching.Json;

namespace ErrorMatching.Hmi;

/// <summary>Whether the account of this process can read what a station needs: the cell's configuration and its keys.</summary>
/// <remarks>A station decides in its own process, with the key of the audit trail. So it needs the cell's account, and no group is enough.
/// What is missing altogether is not reported here, but by what reads it.</remarks>
public static class StationAccess
{
    /// <summary>Why a configuration cannot be used by this account; null if it can be read.</summary>
    /// <param name="config">Path of the configuration.</param>
    public static string? Refusal(string config) => Refusal(config, () => SharedFile.OpenRead(config).Dispose());

    /// <summary>Why a cell cannot be decided for by this account; null if its keys can be read.</summary>
    public static string? Refusal(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return Refusal(settings.KeysFolder, () => _ = Directory.EnumerateFileSystemEntries(settings.KeysFolder).FirstOrDefault());
    }

    private static string? Refusal(string path, Action read)
    {
        try
        {
            read();
            return null;
        }
        catch (UnauthorizedAccessException)
        {
            return $"The account {Environment.UserName} may not read {path}. A station decides with the cell's keys, so it runs in a "
                + "session of the cell's account: errormatch, if the Debian package installed the cell. To be in its group is not enough. "
                + "Log in there, or ask the person who administers this computer. To try a station without a cell: "
                + "errormatch-station --demo";
        }
        catch (IOException)
        {
            return null;
        }
    }
}

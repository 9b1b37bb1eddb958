using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>A program folder as its server names it.</summary>
internal static class ServerFolder
{
    /// <summary>The member <c>folder</c>.</summary>
    /// <param name="item">The transport.</param>
    /// <param name="usual">The default folder.</param>
    /// <param name="problems">Receives the error for a folder that leads up.</param>
    public static string Read(JsonItem item, string usual, CellProblems problems)
    {
        if (item.Find("folder") is not { } folder)
            return usual;
        if (folder.Text.Split('/').Contains(".."))
            problems.Refuse(folder, "folder-leads-up", $"the folder \"{folder.Text}\"", "a folder without ..");
        return folder.Text;
    }

    /// <summary>True if both are the same folder of the same server.</summary>
    public static bool AreSame((string Host, int Port, string Folder) a, (string Host, int Port, string Folder) b) =>
        a.Port == b.Port
        && a.Host.Equals(b.Host, StringComparison.OrdinalIgnoreCase)
        && a.Folder.Trim('/').Equals(b.Folder.Trim('/'), StringComparison.OrdinalIgnoreCase);
}

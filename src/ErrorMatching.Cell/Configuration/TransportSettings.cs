namespace ErrorMatching.Cell;

/// <summary>How a machine's programs are reached: <see cref="FolderSettings"/>, <see cref="FtpSettings"/> or <see cref="SftpSettings"/>.</summary>
public abstract record TransportSettings;

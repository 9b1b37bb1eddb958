# Removes what install.ps1 installed in the folder that this script is in, and nothing else. The configuration, store, keys and logs of a
# cell, and the preferences of users, stay.
#   powershell -ExecutionPolicy Bypass -File uninstall.ps1
param(
    # The installed program, if it is not the one that this script belongs to.
    [string] $Target = ''
)
. (Join-Path $PSScriptRoot 'install-steps.ps1')

if ($Target -eq '') { $Target = $PSScriptRoot }
$Target = $ExecutionContext.SessionState.Path.GetUnresolvedProviderPathFromPSPath($Target).TrimEnd('\', '/')
if (Test-Link $Target) { throw "$Target is a link to another place. Name the place itself with -Target." }
$manifest = if (Test-Path -LiteralPath $Target -PathType Container) { Read-Manifest $Target }
if ($null -eq $manifest -or @($manifest.files).Count -eq 0) {
    "Nothing is installed in $Target."
    return
}

$product = $Products[[string] $manifest.product]
$program = Join-Path $Target $product.Program
$listed = Get-Listed $manifest
foreach ($relative in @($listed.Keys) + @($manifest.shortcuts)) { Join-Below $Target $relative | Out-Null }
if (-not $manifest.isFilesOnly) {
    if (-not (Test-Windows)) { throw 'It was installed by Windows, and has to be removed there.' }
    if ($manifest.isForAll -and -not (Test-Administrator)) { throw 'It was installed for all users: an administrator can remove it.' }
    $services = @(Get-ServicesOf $Target)
    if ($services.Count -gt 0) {
        throw "A service runs this program. Stop and remove it first: sc.exe stop $($services[0]), then sc.exe delete $($services[0])."
    }
}
Assert-NotRunning $program

if (-not $manifest.isFilesOnly) {
    # Only what still belongs to this folder: another installation may have taken it over.
    if ((Get-Value (Get-UninstallKey $manifest.isForAll $product) 'InstallLocation') -eq $Target) {
        Remove-Item -LiteralPath (Get-UninstallKey $manifest.isForAll $product) -Recurse
    }
    if ($manifest.product -eq 'console') {
        Edit-Path $manifest.isForAll { param($entries) Remove-Entry $entries $Target }
    }
    else {
        $open = Get-OpenWithKey $manifest.isForAll $product
        if ((Get-Value "$open\shell\open\command" '') -eq "`"$program`" `"%1`"") { Remove-Item -LiteralPath $open -Recurse }
        Remove-Shortcuts $manifest.isForAll $program @($manifest.shortcuts)
    }
}

# The folder cannot be removed while somebody is in it.
if ("$(Get-Location)$([IO.Path]::DirectorySeparatorChar)".StartsWith("$Target$([IO.Path]::DirectorySeparatorChar)", 'OrdinalIgnoreCase')) {
    Set-Location -LiteralPath (Split-Path -Parent $Target)
}
$left = @(Remove-Listed $Target $listed)
$unknown = @(Get-FilesBelow $Target | Where-Object { -not $listed.ContainsKey($_) -and $_ -ne $ManifestName })
"$($product.Title) $($manifest.version) was removed from $Target."
if ($left.Count + $unknown.Count -gt 0) {
    'These files are not from install.ps1, or were changed, and stay:'
    $left + $unknown | ForEach-Object { "  $_" }
    # An empty list: install.ps1 may use the folder again.
    $manifest.files = @()
    Write-Manifest $Target $manifest
    return
}

[IO.File]::Delete((Join-Path $Target $ManifestName))

foreach ($folder in $Target, (Split-Path -Parent $Target)) {
    # "ErrorMatching" may also have the other program.
    $isOurs = $folder -eq $Target -or (Split-Path -Leaf $folder) -eq 'ErrorMatching'
    if ($isOurs -and (Test-Path -LiteralPath $folder) -and @([IO.Directory]::GetFileSystemEntries($folder)).Count -eq 0) {
        [IO.Directory]::Delete($folder)
    }
}
